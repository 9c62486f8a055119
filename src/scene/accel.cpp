// Building Embree scenes and tracing rays through them.
#include "scene/accel.h"

#include <atomic>
#include <stdexcept>
#include <string>

#include "core/parallel.h"
#include "scene/accel_embree.h"
#include "scene/user_geometry.h"

namespace umbral {
namespace {

bool count_bytes(void* counter, ssize_t bytes, bool) {
  static_cast<std::atomic<ssize_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
  return true;
}

void require_success(RTCDevice device, const char* what) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  throw std::runtime_error(
      std::string("Embree failed to ") + what +
      (error == RTC_ERROR_OUT_OF_MEMORY ? ": out of memory" : ": error " + std::to_string(error)));
}

RTCGeometry triangle_geometry(RTCDevice device, const TracedMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices.data(), 0,
                             sizeof(Vertex), mesh.vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(),
                             offsetof(Triangle, vertices), sizeof(Triangle), mesh.triangles.size());
  return geometry;
}

RTCGeometry instance_geometry(RTCDevice device, RTCScene object, const Affine& to_world) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, object);
  float matrix[12];  // columns
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      matrix[3 * column + row] = static_cast<float>(to_world.linear[column][row]);
  for (int row = 0; row < 3; ++row) matrix[9 + row] = static_cast<float>(to_world.offset[row]);
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, matrix);
  return geometry;
}

}  // namespace

struct Accel::Impl {
  RTCDevice device = nullptr;
  std::vector<RTCScene> scenes;                     // one a group
  std::vector<std::vector<PieceContext>> contexts;  // likewise; Embree points into them
  std::atomic<ssize_t> bytes{0};
  std::uint32_t first_instance = 0;  // instances follow the world's own pieces

  ~Impl() {
    for (RTCScene scene : scenes) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void attach(RTCScene scene, RTCGeometry geometry, std::uint32_t id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  RTCScene new_scene() {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);  // no ray passes between two triangles that share an edge
    scenes.push_back(scene);
    return scene;
  }

  // Embree keeps an error for the thread that it came up in.
  void commit(RTCScene scene) const {
    rtcCommitScene(scene);
    require_success(device, "build the scene");
  }

  void attach_pieces(RTCScene scene, const Group& group, std::vector<PieceContext>& pieces) {
    for (std::uint32_t id = 0; id < group.pieces.size(); ++id) {
      const PieceContext& context = pieces[id];
      if (context.piece->analytic != no_index) {
        attach(scene, make_user_geometry(device, context), id);
        continue;
      }
      RTCGeometry geometry = triangle_geometry(device, context.geometry->meshes[context.piece->mesh]);
      if (!context.material->stops_all()) set_alpha_filter(geometry, context);
      attach(scene, geometry, id);
    }
  }
};

Accel::Accel(const Geometry& geometry, const std::vector<Material>& materials,
             const std::vector<Texture>& textures)
    : impl_(new Impl) {
  impl_->device = rtcNewDevice("hugepages=1");
  if (impl_->device == nullptr) throw std::runtime_error("Embree cannot start on this processor");
  rtcSetDeviceMemoryMonitorFunction(impl_->device, count_bytes, &impl_->bytes);
  for (const Group& group : geometry.groups) {
    std::vector<PieceContext>& pieces = impl_->contexts.emplace_back();
    for (const Piece& piece : group.pieces)
      pieces.push_back({&geometry, &piece, &materials[index_of(piece.material)], &textures});
  }
  for (std::size_t i = 0; i < geometry.groups.size(); ++i)
    impl_->attach_pieces(impl_->new_scene(), geometry.groups[i], impl_->contexts[i]);
  // Embree divides a large group among all threads, and small ones go side by side. The world has them all in it.
  parallel_for(impl_->scenes.size() - 1, [&](std::size_t i) { impl_->commit(impl_->scenes[i + 1]); });
  impl_->first_instance = static_cast<std::uint32_t>(geometry.groups[0].pieces.size());
  std::uint32_t id = impl_->first_instance;
  for (const Placement& placement : geometry.instances)
    impl_->attach(impl_->scenes[0],
                  instance_geometry(impl_->device, impl_->scenes[placement.group], placement.to_world), id++);
  impl_->commit(impl_->scenes[0]);
}

Accel::~Accel() = default;

namespace {

RTCRay embree_ray(const Ray& ray) {
  RTCRay result;
  result.org_x = ray.o.x;
  result.org_y = ray.o.y;
  result.org_z = ray.o.z;
  result.dir_x = ray.d.x;
  result.dir_y = ray.d.y;
  result.dir_z = ray.d.z;
  result.tnear = ray.t_min;
  result.tfar = ray.t_max;
  result.time = 0;
  result.mask = ~0u;
  result.id = 0;
  result.flags = 0;
  return result;
}

}  // namespace

std::optional<Hit> Accel::intersect(const Ray& ray) const {
  RTCRayHit ray_hit;
  ray_hit.ray = embree_ray(ray);
  ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray_hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(impl_->scenes[0], ray_hit);
  if (ray_hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const std::uint32_t top = ray_hit.hit.instID[0];
  const std::uint32_t instance = top == RTC_INVALID_GEOMETRY_ID ? no_index : top - impl_->first_instance;
  return Hit{
      ray_hit.ray.tfar, instance, ray_hit.hit.geomID, ray_hit.hit.primID, {ray_hit.hit.u, ray_hit.hit.v}};
}

bool Accel::occluded(const Ray& ray) const {
  RTCRay embree = embree_ray(ray);
  embree::occluded(impl_->scenes[0], embree);
  return embree.tfar < 0;
}

Bounds Accel::bounds() const {
  RTCBounds bounds;
  rtcGetSceneBounds(impl_->scenes[0], &bounds);
  return {{bounds.lower_x, bounds.lower_y, bounds.lower_z}, {bounds.upper_x, bounds.upper_y, bounds.upper_z}};
}

std::size_t Accel::bytes() const { return static_cast<std::size_t>(impl_->bytes.load()); }

}  // namespace umbral
