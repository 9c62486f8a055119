// The cases of Khronos's glTF validator: what it calls an error is refused, the rest is accepted, but for the breaches
// that cannot change an image, which docs/formats.md lists.
#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

#include <nlohmann/json.hpp>

#include "formats/gltf/document_reader.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using Names = std::set<std::string>;

// Errors of the validator that are warnings here, by what they are about.
const Names& harmless() {
  static const Names names{
      // said twice or too little, without any doubt of what is meant
      "EMPTY_ENTITY", "DUPLICATE_ELEMENTS", "UNDECLARED_EXTENSION", "NON_REQUIRED_EXTENSION",
      "BUFFER_VIEW_TARGET_OVERRIDE", "MESH_PRIMITIVE_INVALID_ATTRIBUTE",
      "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY", "SKIN_NO_COMMON_ROOT", "SKIN_SKELETON_INVALID",
      "NODE_SKIN_NO_SCENE", "UNUSED_EXTENSION_REQUIRED",
      // layouts that other hardware could not read
      "ACCESSOR_OFFSET_ALIGNMENT", "ACCESSOR_TOTAL_OFFSET_ALIGNMENT", "ACCESSOR_MATRIX_ALIGNMENT",
      "MESH_PRIMITIVE_ACCESSOR_UNALIGNED", "MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE",
      // what is told beside the values themselves, which hold
      "ACCESSOR_MIN_MISMATCH", "ACCESSOR_MAX_MISMATCH", "ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND",
      "ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", "MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS",
      // values that are brought to their length, sum or range
      "ACCESSOR_VECTOR3_NON_UNIT", "ACCESSOR_INVALID_SIGN", "ACCESSOR_WEIGHTS_NON_NORMALIZED",
      "ACCESSOR_WEIGHTS_NEGATIVE", "ACCESSOR_JOINTS_INDEX_OOB", "ACCESSOR_JOINTS_INDEX_DUPLICATE",
      "ACCESSOR_NON_CLAMPED", "ACCESSOR_INVALID_IBM", "ROTATION_NON_UNIT",
      // textures without coordinates or tangents: coordinates are (0, 0), tangents are made
      "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", "MESH_PRIMITIVE_NO_TANGENT_SPACE",
      // images are opened where a material shows them
      "IO_ERROR image", "IMAGE_DATA_INVALID", "IMAGE_UNEXPECTED_EOS", "IMAGE_MIME_TYPE_INVALID",
      "IMAGE_NON_ENABLED_MIME_TYPE", "TEXTURE_INVALID_IMAGE_MIME_TYPE"};
  return names;
}

// Animations are not shown: of them only the references are looked at.
bool is_of_animation(const std::string& pointer) { return pointer.starts_with("/animations/"); }

struct Case {
  std::filesystem::path file;
  Names errors, breaches;  // by the validator; those that must be refused, those that may be told alone
};

Case case_of(const std::filesystem::path& report) {
  Case result;
  const std::string name = report.string();
  result.file = name.substr(0, name.size() - std::string(".report.json").size());
  std::ifstream in(report);
  const nlohmann::json json = nlohmann::json::parse(in);
  for (const nlohmann::json& message : json["issues"]["messages"]) {
    if (message["severity"] != 0) continue;
    std::string code = message["code"];
    const std::string pointer = message.value("pointer", "");
    if (code == "IO_ERROR" && pointer.starts_with("/images")) code += " image";
    if (code == "UNSATISFIED_DEPENDENCY" && pointer.ends_with("/byteOffset"))
      code = "EMPTY_ENTITY";  // it is 0
    const bool accepted =
        harmless().contains(code) ||
        (is_of_animation(pointer) && code != "UNRESOLVED_REFERENCE" && code != "TYPE_MISMATCH" &&
         code != "UNDEFINED_PROPERTY" && code != "UNEXPECTED_EXTENSION_OBJECT");
    (accepted ? result.breaches : result.errors).insert(code + " " + pointer);
  }
  return result;
}

std::string listed(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += name + "; ";
  return text;
}

struct Verdict {
  bool accepted;
  std::string messages;
};

Verdict verdict(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  InputFiles files;
  gltf::Report report(diagnostics, file.string());
  bool accepted = false;
  try {
    accepted = gltf::read_document(file, files, report).has_value();
    report.finish();
    diagnostics.throw_errors();
  } catch (const SceneError& error) {
    return {false, error.what()};
  }
  std::string messages;
  for (const Diagnostic& warning : diagnostics.warnings()) messages += warning.text() + '\n';
  return {accepted, messages};
}

TEST(GltfValidator, CasesGetTheVerdictOfTheirReports) {
  const auto folder = test::shared_scene("robustness/gltf-validator");
  if (!folder) GTEST_SKIP() << test::no_shared_scenes;
  int cases = 0, refused = 0, lenient = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder)) {
    if (!entry.path().string().ends_with(".report.json")) continue;
    const Case expected = case_of(entry.path());
    const Verdict found = verdict(expected.file);
    ++cases;
    // Buffers are files beside the glTF file: nothing is fetched from elsewhere.
    const bool fetched = expected.file.filename() == "non_relative_uri.gltf";
    EXPECT_EQ(found.accepted, expected.errors.empty() && !fetched)
        << expected.file << "\n  errors by the validator: " << listed(expected.errors)
        << listed(expected.breaches) << "\n  here: " << found.messages;
    refused += found.accepted ? 0 : 1;
    lenient += found.accepted && !expected.breaches.empty() ? 1 : 0;
  }
  EXPECT_EQ(cases, 372);
  RecordProperty("refused", refused);
  RecordProperty("accepted with breaches", lenient);
}

}  // namespace
}  // namespace umbral
