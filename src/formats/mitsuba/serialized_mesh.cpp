// Inflating a .serialized file and sorting its arrays.
#include "formats/mitsuba/serialized_mesh.h"

#include <zlib.h>

#include <cstring>

#include <fmt/format.h>

#include "core/error.h"

namespace umbral::mitsuba_file {
namespace {

enum Flags : std::uint32_t {
  has_normals = 0x0001,
  has_uvs = 0x0002,
  has_colors = 0x0008,
  flat_faces = 0x0010,
  double_precision = 0x2000,
};

[[noreturn]] void fail(const std::string& name, const std::string& message) {
  throw SceneError(Where{name}, message);
}

template <class T>
T number_at(const std::string& name, std::string_view bytes, std::size_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) fail(name, "the file ends too early");
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

// What is compressed by zlib from some byte on, read piece by piece.
class Inflated {
 public:
  Inflated(const std::string& name, std::string_view bytes) : name_(name) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream_.avail_in = static_cast<uInt>(std::min<std::size_t>(bytes.size(), 0xffffffffu));
    if (inflateInit(&stream_) != Z_OK) fail(name_, "zlib does not start");
  }
  ~Inflated() { inflateEnd(&stream_); }
  Inflated(const Inflated&) = delete;
  Inflated& operator=(const Inflated&) = delete;

  void read(void* to, std::size_t size) {
    stream_.next_out = static_cast<Bytef*>(to);
    stream_.avail_out = static_cast<uInt>(size);
    while (stream_.avail_out > 0) {
      const int state = inflate(&stream_, Z_SYNC_FLUSH);
      if (stream_.avail_out == 0) return;
      if (state != Z_OK) fail(name_, "the compressed mesh is broken or ends too early");
    }
  }

  template <class T>
  T number() {
    T value;
    read(&value, sizeof(T));
    return value;
  }

  // Grows as the data come, so that a wrong count takes no memory.
  template <class T>
  std::vector<T> list(std::uint64_t count) {
    constexpr std::uint64_t piece = 1 << 16;
    std::vector<T> values;
    while (values.size() < count) {
      const std::size_t before = values.size();
      values.resize(before + std::min(piece, count - before));
      read(values.data() + before, (values.size() - before) * sizeof(T));
    }
    return values;
  }

  std::vector<float> floats(std::uint64_t count, bool doubles) {
    if (!doubles) return list<float>(count);
    const std::vector<double> values = list<double>(count);
    return {values.begin(), values.end()};
  }

 private:
  const std::string& name_;
  z_stream stream_{};
};

// Where the mesh begins: the offsets of all stand at the end of the file, before their number.
std::size_t offset_of(const std::string& name, std::string_view bytes, int version, int index) {
  if (index == 0) return 0;
  const std::size_t width = version == 4 ? 8 : 4;
  if (bytes.size() < 4) fail(name, "the file ends too early");
  const auto count = number_at<std::uint32_t>(name, bytes, bytes.size() - 4);
  if (index < 0 || static_cast<std::uint32_t>(index) >= count)
    fail(name, fmt::format("there is no mesh {} among its {}, which are numbered from 0", index, count));
  const std::uint64_t back = 4 + width * (std::uint64_t{count} - static_cast<std::uint32_t>(index));
  if (back > bytes.size()) fail(name, "the file ends too early");
  const std::size_t at = bytes.size() - back;
  return width == 8 ? number_at<std::uint64_t>(name, bytes, at) : number_at<std::uint32_t>(name, bytes, at);
}

Mesh mesh_in(const std::string& name, Inflated& in, int version) {
  const auto flags = in.number<std::uint32_t>();
  if (version == 4)
    while (in.number<char>() != 0) {
    }
  const auto vertices = in.number<std::uint64_t>(), triangles = in.number<std::uint64_t>();
  if (vertices > 0xfffffff0u || triangles > 0xfffffff0u)
    fail(name, fmt::format("it cannot have {} vertices and {} triangles", vertices, triangles));
  const bool doubles = (flags & double_precision) != 0;
  const auto vectors = [&](std::vector<Vec3>& to) {
    const std::vector<float> v = in.floats(3 * vertices, doubles);
    for (std::size_t i = 0; i + 2 < v.size(); i += 3) to.push_back({v[i], v[i + 1], v[i + 2]});
  };
  Mesh mesh;
  vectors(mesh.positions);
  if ((flags & has_normals) != 0) vectors(mesh.normals);
  if ((flags & has_uvs) != 0) {
    const std::vector<float> uv = in.floats(2 * vertices, doubles);
    for (std::size_t i = 0; i + 1 < uv.size(); i += 2) mesh.uvs.push_back({uv[i], uv[i + 1]});
  }
  if ((flags & has_colors) != 0) in.floats(3 * vertices, doubles);
  mesh.triangles = in.list<glm::uvec3>(triangles);
  for (const glm::uvec3& t : mesh.triangles)
    if (std::max({t.x, t.y, t.z}) >= vertices)
      fail(name, fmt::format("a triangle names vertex {} of {}", std::max({t.x, t.y, t.z}), vertices));
  for (const Vec3& p : mesh.positions)
    if (!is_finite(p)) fail(name, "a vertex is not finite");
  if ((flags & flat_faces) != 0) mesh.normals.clear();
  return mesh;
}

}  // namespace

Mesh read_serialized_mesh(const std::string& name, std::string_view bytes, int index) {
  constexpr std::uint16_t magic = 0x041c;
  if (number_at<std::uint16_t>(name, bytes, 0) != magic) fail(name, "this is no serialized mesh");
  const int version = number_at<std::uint16_t>(name, bytes, 2);
  if (version != 3 && version != 4)
    fail(name, fmt::format("serialized meshes of version {} are not read, only 3 and 4", version));
  const std::size_t offset = offset_of(name, bytes, version, index);
  if (offset > bytes.size() || bytes.size() - offset < 4) fail(name, "the file ends too early");
  Inflated in(name, bytes.substr(offset + 4));
  return mesh_in(name, in, version);
}

}  // namespace umbral::mitsuba_file
