// Metals, coats and facets of other formats: what is the same here, and what is told to be near it.
#include "bsdf/interfaces/fresnel.h"
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

template <class Lobe>
Lobe lobe_in(const SceneFile& file, std::size_t shape = 0) {
  return std::get<Lobe>(file.scene.materials.at(index_of(file.scene.shapes.at(shape).material)).lobe);
}

SceneFile pbrt(const SceneFolder& folder, const std::string& material) {
  folder.write("scene.pbrt", "WorldBegin\nMaterial " + material + "\nShape \"sphere\"\n");
  return folder.read("scene.pbrt");
}

std::string xml(const std::string& bsdf) {
  return "<scene version='3.0.0'><shape type='sphere'>\n<bsdf type='" + bsdf + "</bsdf></shape></scene>";
}

SceneFile mitsuba(const SceneFolder& folder, const std::string& bsdf) {
  folder.write("scene.xml", xml(bsdf));
  return folder.read("scene.xml");
}

// alpha (1 ± anisotropy), the larger along the rotated u.
void expect_widths(const Conductor& metal, double alpha_u, double alpha_v) {
  const double mean = sqr(static_cast<double>(metal.roughness)), spread = mean * metal.anisotropy;
  EXPECT_NEAR(mean + spread, std::max(alpha_u, alpha_v), 1e-6);
  EXPECT_NEAR(mean - spread, std::min(alpha_u, alpha_v), 1e-6);
  EXPECT_EQ(metal.anisotropy_rotation, alpha_u < alpha_v ? 90 : 0);
}

TEST(Facets, OfMetalsAndGlassMayDifferInUAndV) {
  const SceneFolder folder;
  expect_widths(lobe_in<Conductor>(pbrt(folder,
                                        "\"conductor\" \"float uroughness\" .3 \"float vroughness\" .1"
                                        " \"bool remaproughness\" false")),
                0.3, 0.1);
  expect_widths(
      lobe_in<Conductor>(pbrt(folder, "\"conductor\" \"float uroughness\" .04 \"float vroughness\" .09")),
      0.2, 0.3);
  expect_widths(lobe_in<Conductor>(mitsuba(folder,
                                           "roughconductor'><string name='distribution' value='ggx'/>"
                                           "<float name='alpha_u' value='.05'/><float name='alpha_v' "
                                           "value='.4'/><string name='material' value='Al'/>")),
                0.05, 0.4);
  const auto glass =
      lobe_in<Dielectric>(pbrt(folder, "\"dielectric\" \"float uroughness\" .0025 \"float vroughness\" .01"));
  EXPECT_NEAR(sqr(glass.roughness) * (1 + glass.anisotropy), 0.1, 1e-6);
  EXPECT_NEAR(sqr(glass.roughness) * (1 - glass.anisotropy), 0.05, 1e-6);
  EXPECT_EQ(glass.anisotropy_rotation, 90);
  folder.write("scene.pbrt",
               "WorldBegin\nMaterial \"coateddiffuse\" \"float uroughness\" .1\nShape \"sphere\"\n");
  EXPECT_EQ(folder.errors("scene.pbrt"),
            "scene.pbrt:2:1: error: not supported: roughness that differs in u and v under or on a coat; "
            "--lenient leaves it out\n    2 | Material \"coateddiffuse\" \"float uroughness\" .1\n      | ^");
}

TEST(Facets, MayBeOfImages) {
  const SceneFolder folder;
  folder.write("r.ppm", "P3 2 1 255\n26 26 26  255 255 255\n");
  folder.write(
      "scene.pbrt",
      "WorldBegin\nTexture \"r\" \"float\" \"imagemap\" \"string filename\" \"r.ppm\" \"string encoding\" "
      "\"linear\"\nMaterial \"conductor\" \"texture roughness\" \"r\" Shape \"sphere\"\nMaterial "
      "\"coateddiffuse\" \"texture roughness\" \"r\" \"bool remaproughness\" false Shape \"sphere\"\n");
  const SceneFile file = folder.read("scene.pbrt");
  const auto at = [&](std::size_t shape, float u) {
    return file.scene.materials.at(index_of(file.scene.shapes.at(shape).material))
        .at(Vec2(u, 0.5f), file.scene.textures);
  };
  const double dark = 26 / 255.0;
  EXPECT_NEAR(std::get<Conductor>(at(0, 0.25f)).roughness, std::pow(dark, 0.25), 1e-5);
  EXPECT_NEAR(std::get<Conductor>(at(0, 0.75f)).roughness, 1, 1e-5);
  EXPECT_NEAR(std::get<Plastic>(at(1, 0.25f)).roughness, std::sqrt(dark), 1e-5);
  folder.write("scene.xml",
               xml("roughdielectric'><string name='distribution' value='ggx'/><texture name='alpha' "
                   "type='checkerboard'><rgb name='color0' value='.04'/><rgb name='color1' value='.25'/>"
                   "</texture>"));
  const SceneFile other = folder.read("scene.xml");
  const Material& glass = other.scene.materials.at(index_of(other.scene.shapes.at(0).material));
  EXPECT_NEAR(std::get<Dielectric>(glass.at(Vec2(0.1f, 0.1f), other.scene.textures)).roughness, 0.2, 1e-5);
  EXPECT_NEAR(std::get<Dielectric>(glass.at(Vec2(0.6f, 0.1f), other.scene.textures)).roughness, 0.5, 1e-5);
  folder.write(
      "scene.pbrt",
      "WorldBegin\nTexture \"a\" \"float\" \"mix\"\nMaterial \"conductor\" \"texture roughness\" \"a\" "
      "Shape \"sphere\"\n");
  EXPECT_TRUE(
      contains(folder.errors("scene.pbrt"), "not supported: a texture for roughness that is no image"));
}

TEST(CoatedMetals, AreCoatsOverMetalsInThem) {
  const SceneFolder folder;
  const SceneFile file =
      pbrt(folder,
           "\"coatedconductor\" \"float interface.roughness\" .0001 \"float interface.eta\" 1.6 "
           "\"float conductor.uroughness\" .04 \"float conductor.vroughness\" .01 \"spectrum "
           "conductor.eta\" \"metal-Au-eta\" \"spectrum conductor.k\" \"metal-Au-k\" \"float "
           "thickness\" .1 \"integer maxdepth\" 9");
  const Material& coated = file.scene.materials.at(index_of(file.scene.shapes.at(0).material));
  const Coat& coat = std::get<Coat>(coated.lobe);
  EXPECT_FLOAT_EQ(coat.eta, 1.6f);
  EXPECT_NEAR(sqr(coat.roughness), 0.01, 1e-6);
  ASSERT_EQ(coated.parts.size(), 1u);
  const Conductor& metal =
      std::get<Conductor>(file.scene.materials.at(index_of(coated.parts[0].material)).lobe);
  expect_widths(metal, 0.2, 0.1);
  const ComplexIndex gold = metal_index(Metal::Au);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(metal.eta[c], gold.eta[c] / 1.6f, 1e-6f);
    EXPECT_NEAR(metal.k[c], gold.k[c] / 1.6f, 1e-6f);
  }
}

TEST(Beckmann, IsShownByGgxAndSaysSo) {
  const SceneFolder folder;
  const SceneFile file = mitsuba(folder, "roughconductor'><float name='alpha' value='.04'/>");
  EXPECT_NEAR(lobe_in<Conductor>(file).roughness, 0.2, 1e-6);
  EXPECT_TRUE(file.left_out.empty());
  ASSERT_EQ(file.approximated.size(), 1u);
  EXPECT_TRUE(contains(file.approximated[0], "scene.xml:2: facets of the 'beckmann' distribution by GGX's"));
  EXPECT_TRUE(contains(folder.warnings(file),
                       "scene.xml:2:2: warning: approximated: facets of the 'beckmann' distribution"))
      << folder.warnings(file);
}

TEST(TintedMetals, ReflectLessAtEveryAngle) {
  const SceneFolder folder;
  const SceneFile file =
      mitsuba(folder,
              "roughconductor'><string name='distribution' value='ggx'/><float name='alpha' value='.1'/>"
              "<rgb name='eta' value='.2 .92 1.1'/><rgb name='k' value='3.9 2.45 2.14'/>"
              "<rgb name='specular_reflectance' value='.3 .5 1'/>");
  const Conductor& metal = lobe_in<Conductor>(file);
  const Spectrum eta = rgb(.2f, .92f, 1.1f), k = rgb(3.9f, 2.45f, 2.14f), tint = rgb(.3f, .5f, 1);
  for (const float c : {1.0f, 0.8f, 0.6f, 0.4f}) {
    const Spectrum wanted = tint * fresnel_conductor(c, eta, k), got = metal.fresnel(c);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(got[channel], wanted[channel], 0.03) << c;
  }
  Conductor untinted;
  untinted.eta = eta;
  untinted.k = k;
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(metal.fresnel_average()[channel], tint[channel] * untinted.fresnel_average()[channel], 1e-5);
  EXPECT_EQ(file.approximated.size(), 1u);
  EXPECT_EQ(lobe_in<Mirror>(mitsuba(folder, "conductor'><rgb name='specular_reflectance' value='.3 .5 1'/>"))
                .reflectance,
            tint);
  folder.write("scene.xml", xml("dielectric'><rgb name='specular_transmittance' value='.5'/>"));
  EXPECT_TRUE(contains(folder.errors("scene.xml"), "not supported: 'specular_transmittance', a tint"));
}

// Two triangles with a colour each, which are those of faces where the file asks for them.
TEST(MeshAttributes, ColoursOfFaces) {
  const SceneFolder folder;
  folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property float color_0\nproperty float color_1\nproperty float color_2\nelement face 2\n"
      "property list uchar int vertex_indices\nproperty float color_0\nproperty float color_1\n"
      "property float color_2\nend_header\n0 0 0 1 1 1\n1 0 0 1 1 1\n1 1 0 1 1 1\n0 1 0 1 1 1\n"
      "3 0 1 2 .5 0 0\n3 0 2 3 0 .25 0\n");
  const auto read = [&](const std::string& attribute) {
    folder.write(
        "scene.xml",
        "<scene version='3.0.0'><shape type='ply'><string name='filename' value='a.ply'/><bsdf "
        "type='diffuse'><texture name='reflectance' type='mesh_attribute'><string name='name' value='" +
            attribute + "'/></texture></bsdf></shape></scene>");
    return std::get<Mesh>(folder.read("scene.xml").scene.shapes.at(0).kind);
  };
  const Mesh faces = read("face_color"), vertices = read("vertex_color");
  EXPECT_EQ(vertices.colors.at(0), Spectrum(1, 1, 1, 1));
  EXPECT_EQ(vertices.positions.size(), 4u);
  ASSERT_EQ(faces.positions.size(), 6u);
  ASSERT_EQ(faces.triangles.size(), 2u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(faces.colors[faces.triangles[0][k]], Spectrum(0.5f, 0, 0, 1));
    EXPECT_EQ(faces.colors[faces.triangles[1][k]], Spectrum(0, 0.25f, 0, 1));
  }
  EXPECT_EQ(faces.positions[faces.triangles[1].z], Vec3(0, 1, 0));
}

// What is of little weight for the look does not keep a scene from being rendered.
TEST(Approximations, OfFilmsFiltersAndIntegratorsAreTold) {
  const SceneFolder folder;
  folder.write(
      "scene.pbrt",
      "Film \"rgb\" \"string sensor\" \"canon_eos_5d\" \"float whitebalance\" 5000 \"float "
      "maxcomponentvalue\" 10\nPixelFilter \"gaussian\" \"float xradius\" 2 \"float yradius\" 2 \"float "
      "sigma\" .5\nIntegrator \"path\" \"bool regularize\" true\nWorldBegin\nShape \"sphere\"\n");
  const SceneFile file = folder.read("scene.pbrt");
  EXPECT_EQ(file.film.filter_radius, 1.5f);
  ASSERT_EQ(file.approximated.size(), 5u);
  EXPECT_TRUE(contains(file.approximated[0], "scene.pbrt:1: the colours of the sensor 'canon_eos_5d'"));
  EXPECT_TRUE(contains(file.approximated[1], "white balance"));
  EXPECT_TRUE(contains(file.approximated[2], "cut off by whole ones"));
  EXPECT_TRUE(contains(file.approximated[3], "scene.pbrt:2: a gaussian that is cut at its radius"));
  EXPECT_TRUE(contains(file.approximated[4], "scene.pbrt:3: roughness that is added"));
  folder.write(
      "scene.xml",
      "<scene version='3.0.0'><sensor type='perspective'><film type='hdrfilm'><rfilter type='lanczos'>"
      "<integer name='lobes' value='3'/></rfilter></film></sensor><shape type='sphere'/></scene>");
  const SceneFile other = folder.read("scene.xml");
  EXPECT_EQ(other.film.filter, FilterKind::gaussian);
  ASSERT_EQ(other.approximated.size(), 1u);
  EXPECT_TRUE(contains(other.approximated[0], "the filter 'lanczos' by a gaussian"));
}

TEST(OrthographicCameras, SeeAPartOfTheirPlane) {
  const SceneFolder folder;
  folder.write("scene.pbrt",
               "Film \"rgb\" \"integer xresolution\" 400 \"integer yresolution\" 200\nScale .5 .5 .5\n"
               "LookAt 0 0 5 0 0 0 0 1 0\nCamera \"orthographic\" \"float screenwindow\" [ -4 4 -2 2 ]\n"
               "WorldBegin\nShape \"sphere\"\n");
  // The screen of 4 units is in the camera's own, of which the world has half as many.
  EXPECT_FLOAT_EQ(folder.read("scene.pbrt").scene.camera.orthographic_height, 8);
  folder.write("scene.xml",
               "<scene version='3.0.0'><sensor type='orthographic'><transform name='to_world'>"
               "<scale x='10' y='10'/><lookat origin='0,0,5' target='0,0,0' up='0,1,0'/></transform><film "
               "type='hdrfilm'><integer name='width' value='400'/><integer name='height' value='200'/></film>"
               "</sensor><shape type='sphere'/></scene>");
  const CameraSettings camera = folder.read("scene.xml").scene.camera;
  EXPECT_FLOAT_EQ(camera.orthographic_height, 10) << "Mitsuba's is two units wide";
  EXPECT_EQ(camera.position, Vec3(0, 0, 5));
}

}  // namespace
}  // namespace umbral
