// MTL materials: which lobe each becomes, with which numbers, and what is said of it.
#include "scene_folder.h"

namespace umbral {
namespace {

using test::contains;
using test::SceneFolder;

// A triangle of the material "m", of which the MTL file says `mtl`.
class MtlScene {
 public:
  explicit MtlScene(const std::string& mtl, const SceneFolder& folder = {}) : file_(read(mtl, folder)) {
    warnings_ = folder.warnings(file_);
  }

  const Material& material() const { return file_.scene.materials.at(0); }
  const Shape& shape() const { return file_.scene.shapes.at(0); }
  const std::vector<Texture>& textures() const { return file_.scene.textures; }
  const std::string& warnings() const { return warnings_; }
  template <class Lobe>
  const Lobe& lobe() const {
    return std::get<Lobe>(material().lobe);
  }
  // The lobe as it is at a point, textures looked up.
  Lobes at(const Vec2& uv) const { return material().at(uv, file_.scene.textures); }

 private:
  static SceneFile read(const std::string& mtl, const SceneFolder& folder) {
    folder.write("m.mtl", "newmtl m\n" + mtl);
    folder.write("m.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    return folder.read("m.obj");
  }

  SceneFile file_;
  std::string warnings_;
};

TEST(Mtl, BlackKsIsMatte) {
  const MtlScene scene(
      "  Ns 10\n\tNi 1.5\n  d 1.0\n  Tr 0\n  Tf 1 1 1\n  illum 2\n  Ka 0.9 0.3 0.2 # Orange\n"
      "  Kd 0.9 0.3 0.2\n  Ks 0 0 0\n  Ke 0 0 0\n");
  EXPECT_EQ(scene.lobe<Lambert>().reflectance, rgb(0.9f, 0.3f, 0.2f));
  EXPECT_TRUE(scene.material().is_opaque());
  EXPECT_FALSE(scene.shape().emits());
  EXPECT_FALSE(contains(scene.warnings(), "m.mtl")) << scene.warnings();
}

TEST(Mtl, OneNumberIsGrey) { EXPECT_EQ(MtlScene("Kd 0.25\n").lobe<Lambert>().reflectance, grey(0.25f)); }

TEST(Mtl, OtherKsIsBlinnPhong) {
  const MtlScene scene("Kd 0.5 0.4 0.3\nKs 0.25 0.25 0.125\nNs 77\nKa 0.1 0.2 0.3\nillum 2\n");
  const BlinnPhong& lobe = scene.lobe<BlinnPhong>();
  EXPECT_EQ(lobe.kd, rgb(0.5f, 0.4f, 0.3f));
  EXPECT_EQ(lobe.ks, rgb(0.25f, 0.25f, 0.125f));
  EXPECT_EQ(lobe.ka, rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(lobe.exponent, 77);
  EXPECT_FALSE(contains(scene.warnings(), "m.mtl")) << scene.warnings();
}

TEST(Mtl, IllumWithoutHighlightIsMatte) {
  EXPECT_EQ(MtlScene("illum 1\nKd 0.5\nKs 0.5\n").lobe<Lambert>().reflectance, grey(0.5f));
}

TEST(Mtl, NumbersOutOfRangeAreCutAndTold) {
  const MtlScene scene("Kd 1.5 1 -1\nKs 2 2 2\nNs 2e6\nKa 20 20 20\n");
  const BlinnPhong& lobe = scene.lobe<BlinnPhong>();
  EXPECT_EQ(lobe.kd, rgb(1, 1, 0));
  EXPECT_EQ(lobe.ks, grey(1));
  EXPECT_EQ(lobe.exponent, 1e6f);
  EXPECT_TRUE(contains(
      scene.warnings(),
      "m.mtl:1:8: warning: material 'm': Kd 1.5 1 -1 is cut to 1 1 0; Ks 2 2 2 is cut to 1 1 1; "
      "Ka 20 20 20 is cut to 1 1 1; Ns 2000000 is cut to 1000000\n    1 | newmtl m\n      |        ^\n"))
      << scene.warnings();
  EXPECT_TRUE(contains(scene.warnings(), "kd + ks is 2;")) << scene.warnings();
}

TEST(Mtl, MirrorsByIllum) {
  for (const char* illum : {"illum 5\n", "illum 3\n"}) {
    const MtlScene scene(std::string(illum) +
                         "Ka 0.01 0.01 0.01\nKd 0.01 0.01 0.01\nKs 0.95 0.95 0.95\nNs 1000\n");
    EXPECT_EQ(scene.lobe<Mirror>().reflectance, grey(0.95f));
    EXPECT_TRUE(
        contains(scene.warnings(), "a perfect mirror that reflects Ks; Kd and Ns have no part in it"));
  }
  const MtlScene varnish("illum 3\nKd 0.8 0.8 0.8\nKs 0.1 0.1 0.1\nNs 50\n");
  EXPECT_EQ(varnish.lobe<BlinnPhong>().ks, grey(0.1f));
  EXPECT_TRUE(contains(varnish.warnings(), "the reflections of illum 3 are shown as a highlight"));
}

TEST(Mtl, GlassByIllumAndIndex) {
  const MtlScene glass("Kd 0.01\nKs 0.3\nTf 0.1 0.1 0.1\nNs 200\nNi 2.5\nillum 7\n");
  EXPECT_EQ(glass.lobe<Dielectric>().eta, 2.5f);
  EXPECT_EQ(glass.lobe<Dielectric>().transmittance, grey(1));
  EXPECT_TRUE(glass.material().is_opaque());
  EXPECT_TRUE(contains(glass.warnings(), "clear glass with index 2.5"));
  EXPECT_EQ(MtlScene("Tf 0.2 0.4 0.1\nNi 1.5\nillum 6\n").lobe<Dielectric>().transmittance,
            rgb(0.5f, 1, 0.25f));
  EXPECT_EQ(MtlScene("d 0.1\nNi 1.5\nillum 4\n").lobe<Dielectric>().eta, 1.5f);
  // An index and an illum that say glass by themselves are not enough where nothing lets light through.
  EXPECT_EQ(MtlScene("Kd 0.5\nNi 1.5\nillum 4\n").lobe<Lambert>().reflectance, grey(0.5f));
  EXPECT_EQ(MtlScene("Kd 0.5\nNi 1.5\nillum 2\nd 0.5\n").material().alpha.value, 0.5f);
  EXPECT_EQ(MtlScene("Kd 0.5\nNi 1\nillum 7\n").lobe<Lambert>().reflectance, grey(0.5f));
}

TEST(Mtl, OpacityIsDOrOneMinusTr) {
  EXPECT_EQ(MtlScene("Kd 1\nd 0.75\n").material().alpha.value, 0.75f);
  EXPECT_EQ(MtlScene("Kd 1\nTr 0.75\n").material().alpha.value, 0.25f);
  EXPECT_EQ(MtlScene("Kd 1\nTr 0.5\nd 0.75\n").material().alpha.value, 0.75f);
  const MtlScene hidden("Kd 1\nTr 1\n");
  EXPECT_EQ(hidden.material().alpha.value, 1);
  EXPECT_TRUE(contains(hidden.warnings(), "Tr 1 would make it invisible"));
}

TEST(Mtl, KeIsTheEmissionOfTheShape) {
  const MtlScene lamp("Kd 0.78\nKe 17 12 4\n");
  EXPECT_EQ(lamp.shape().emission.value, rgb(17, 12, 4));
  EXPECT_FALSE(lamp.shape().two_sided);
}

TEST(Mtl, MapsAreMultipliedByTheirColour) {
  const SceneFolder folder;
  folder.write("red.tga", test::tga(2, 2, 255, 0, 0, 255));
  const MtlScene scene(
      "Kd 0.5 0.5 0.5\nKs 0.25 0.25 0.25\nNs 40\nmap_Kd red.tga\nmap_Ks red.tga\nmap_Ns red.tga\n"
      "Ke 3 3 3\nmap_Ke red.tga\n",
      folder);
  const auto lobe = std::get<BlinnPhong>(scene.at({0.5f, 0.5f}));
  EXPECT_EQ(lobe.kd, rgb(0.5f, 0, 0));
  EXPECT_EQ(lobe.ks, rgb(0.25f, 0, 0));
  EXPECT_FLOAT_EQ(lobe.exponent, 40 * 0.2126f);
  ASSERT_FALSE(scene.shape().emission.is_constant());
  EXPECT_EQ(scene.textures()[index_of(scene.shape().emission.map)].color({0.5f, 0.5f}) * rgb(1, 1, 1),
            rgb(3, 0, 0));
  EXPECT_TRUE(scene.material().is_opaque());
}

TEST(Mtl, AColourMultipliesItsMapChannelByChannel) {
  const SceneFolder folder;
  folder.write("white.tga", test::tga(2, 2, 255, 255, 255, 255));
  const MtlScene scene("Kd 0 0.5 1\nmap_Kd white.tga\n", folder);
  EXPECT_EQ(std::get<Lambert>(scene.at({0.5f, 0.5f})).reflectance, rgb(0, 0.5f, 1));
  EXPECT_FALSE(contains(scene.warnings(), "m.mtl")) << scene.warnings();
  const MtlScene dark("Kd 0 0 0\nmap_Kd white.tga\n", folder);
  EXPECT_EQ(std::get<Lambert>(dark.at({0.5f, 0.5f})).reflectance, white);
  EXPECT_TRUE(contains(dark.warnings(), "Kd is black, but map_Kd is used as it is"));
}

TEST(Mtl, OptionsOfMaps) {
  const SceneFolder folder;
  folder.write("a b.tga", test::tga(2, 2, 100, 100, 100, 255));
  const MtlScene scene(
      "Kd 1\nmap_Kd -s 2 3 1 -o 0.25 0.5 -clamp on -mm 0.125 0.5 -colorspace linear -blendu off "
      "-bm 3 a b.tga\n",
      folder);
  const auto& texture = std::get<ImageTexture>(scene.textures().at(0).kind);
  EXPECT_EQ(texture.uv_scale, Vec2(2, 3));
  EXPECT_EQ(texture.uv_offset, Vec2(0.25f, 0.5f));
  EXPECT_EQ(texture.wrap, Wrap::clamp);
  EXPECT_EQ(texture.bias, 0.125f);
  EXPECT_EQ(texture.factor, 0.5f);
  EXPECT_FLOAT_EQ(texture.image->texel(0, 0).r, 100 / 255.0f);
  EXPECT_TRUE(contains(scene.warnings(), "-bm of map_Kd is not used")) << scene.warnings();
  EXPECT_FALSE(contains(scene.warnings(), "-blendu"));
}

TEST(Mtl, AlphaOfMapKdCutsOutWhereThereIsNoMapD) {
  const SceneFolder folder;
  folder.write("leaf.tga", test::tga(2, 1, 10, 200, 10, 0));
  folder.write("mask.tga", test::tga(2, 1, 255, 255, 255, 255));
  const MtlScene leaf("Kd 1\nmap_Kd leaf.tga\n", folder);
  ASSERT_FALSE(leaf.material().alpha.is_constant());
  const Texture& alpha = leaf.textures()[index_of(leaf.material().alpha.map)];
  EXPECT_EQ(alpha.number({0.25f, 0.5f}), 1);
  EXPECT_EQ(alpha.number({0.75f, 0.5f}), 0);
  EXPECT_TRUE(contains(leaf.warnings(), "opacity is the alpha of map_Kd, as there is no map_d"));
  const MtlScene masked("Kd 1\nmap_Kd leaf.tga\nmap_d mask.tga\n", folder);
  EXPECT_EQ(masked.textures()[index_of(masked.material().alpha.map)].number({0.75f, 0.5f}), 1);
  const MtlScene by_alpha("Kd 1\nd 0.5\nmap_d leaf.tga\n", folder);
  EXPECT_EQ(by_alpha.textures()[index_of(by_alpha.material().alpha.map)].number({0.25f, 0.5f}), 0.5f);
}

TEST(Mtl, MissingMapsLeaveTheConstantAndAreToldOnce) {
  const MtlScene scene("Kd 0.25\nmap_Kd none.png\n");
  EXPECT_EQ(scene.lobe<Lambert>().reflectance, grey(0.25f));
  const std::string warning =
      "m.mtl:3:8: warning: none.png: cannot be read: No such file or directory\n    3 | map_Kd none.png\n    "
      "  |        ^\n";
  const std::size_t at = scene.warnings().find(warning);
  ASSERT_NE(at, std::string::npos) << scene.warnings();
  EXPECT_EQ(scene.warnings().find("none.png: cannot", at + warning.size()), std::string::npos);
}

TEST(Mtl, MapsAreFoundBesideTheFileWhereTheirPathIsForeign) {
  const SceneFolder folder;
  folder.write("wood.tga", test::tga(1, 1, 255, 255, 255, 255));
  folder.write("maps/wood2.tga", test::tga(1, 1, 255, 255, 255, 255));
  const MtlScene scene("Kd 1\nmap_Kd C:\\Users\\me\\wood.tga\n", folder);
  EXPECT_FALSE(scene.material().maps.empty());
  EXPECT_TRUE(
      contains(folder.without_folder(scene.warnings()), "'C:\\Users\\me\\wood.tga' was found as 'wood.tga'"))
      << scene.warnings();
  EXPECT_FALSE(MtlScene("Kd 1\nmap_Kd maps\\wood2.tga\n", folder).material().maps.empty());
}

TEST(Mtl, NamesTooLongForAnyFileAreMissingFiles) {
  const std::string name(100000, 'x');
  EXPECT_TRUE(
      contains(MtlScene("Kd 1\nmap_Kd " + name + "\n").warnings(), "cannot be read: File name too long"));
  const SceneFolder folder;
  folder.write("m.obj", "mtllib " + name + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(contains(folder.warnings(folder.read("m.obj")), "cannot be read: File name too long"));
}

TEST(Mtl, PhysicallyBasedOnesArePrincipled) {
  const SceneFolder folder;
  folder.write("half.tga", test::tga(2, 2, 128, 128, 128, 255));
  const MtlScene scene(
      "Kd 0.5 0.4 0.3\nKs 0.5 0.5 0.5\nNs 250\nNi 1.33\nPr 0.25\nPm 1\nmap_Pr half.tga\nPs 0.2\nPc 0.3\n"
      "Pcr 0.1\naniso 0.6\nanisor 0.25\nillum 2\n",
      folder);
  const auto lobe = std::get<Principled>(scene.at({0.5f, 0.5f}));
  EXPECT_EQ(lobe.base_color, rgb(0.5f, 0.4f, 0.3f));
  EXPECT_FLOAT_EQ(lobe.ior, 1.33f);
  EXPECT_EQ(lobe.metallic, 1);
  EXPECT_FLOAT_EQ(lobe.roughness, 0.25f * 128 / 255);
  EXPECT_EQ(lobe.sheen_color, grey(0.2f));
  EXPECT_EQ(lobe.clearcoat, 0.3f);
  EXPECT_EQ(lobe.clearcoat_roughness, 0.1f);
  EXPECT_EQ(lobe.anisotropy, 0.6f);
  EXPECT_FLOAT_EQ(lobe.anisotropy_rotation, 90);
  EXPECT_TRUE(contains(scene.warnings(), "Ks and Ns have no part in it")) << scene.warnings();
  const MtlScene mapped("Kd 1\nPm 0\nmap_Pm half.tga\n", folder);
  EXPECT_FLOAT_EQ(std::get<Principled>(mapped.at({0.5f, 0.5f})).metallic, 128 / 255.0f);
  EXPECT_TRUE(contains(mapped.warnings(), "Pm is 0, but map_Pm is used as it is"));
  EXPECT_TRUE(contains(MtlScene("Kd 1\nPr 2\n").warnings(), "Pr 2 is cut to 1"));
}

TEST(Mtl, NormMapsAndBumps) {
  const SceneFolder folder;
  folder.write("normals.tga", test::tga(2, 2, 128, 128, 255, 255));
  folder.write("heights.tga", test::tga(2, 2, 90, 90, 90, 255));
  EXPECT_TRUE(MtlScene("Kd 1\nnorm normals.tga\n", folder).material().has_normal_map());
  const MtlScene bumped("Kd 1\nbump -bm 0.2 heights.tga\n", folder);
  EXPECT_TRUE(bumped.material().has_bump_map());
  EXPECT_EQ(bumped.material().bump_scale, 0.2f);
  EXPECT_TRUE(contains(bumped.warnings(), "bump is taken as heights of up to 0.2 world units"));
  const MtlScene disguised("Kd 1\nmap_Bump -bm 0.5 normals.tga\n", folder);
  EXPECT_TRUE(disguised.material().has_normal_map());
  EXPECT_FALSE(disguised.material().has_bump_map());
  EXPECT_EQ(disguised.material().normal_scale, 0.5f);
  EXPECT_TRUE(contains(disguised.warnings(), "bump holds a normal map by its colours"));
}

TEST(Mtl, BlendingThatIsOffIsNearest) {
  const SceneFolder folder;
  folder.write("t.tga", test::tga(2, 2, 128, 128, 255, 255));
  const auto filter = [&](const std::string& options) {
    const MtlScene scene("Kd 1\nmap_Kd " + options + " t.tga\n", folder);
    return std::get<ImageTexture>(scene.textures().at(0).kind).filter;
  };
  EXPECT_EQ(filter("-blendu off -blendv off"), TextureFilter::nearest);
  EXPECT_EQ(filter("-blendu off"), TextureFilter::bilinear);
  EXPECT_EQ(filter("-blendu on -blendv on -boost 3 -texres 64 -cc on"), TextureFilter::bilinear);
}

TEST(Mtl, OtherStatementsAreTold) {
  const MtlScene scene("Kd 1\nsharpness 60\ndisp x.png\nsharpness 0.7\nKs xyz 1 2 3\n");
  EXPECT_TRUE(contains(scene.warnings(),
                       "material 'm': 'sharpness' is not used; 'disp' is not used; 'Ks xyz' is not used\n"))
      << scene.warnings();
}

TEST(Mtl, NothingSaidIsGrey) {
  const MtlScene scene("");
  EXPECT_EQ(scene.lobe<Lambert>().reflectance, grey(0.5f));
  EXPECT_TRUE(contains(scene.warnings(), "Kd is not given: 0.5"));
}

TEST(Mtl, ASecondMaterialOfTheSameNameIsTold) {
  const MtlScene scene("Kd 0.25\nnewmtl m\nKd 0.75\n");
  EXPECT_EQ(scene.lobe<Lambert>().reflectance, grey(0.25f));
  EXPECT_TRUE(contains(scene.warnings(),
                       "m.mtl:3:8: warning: there is a material 'm' already; this one is not used"));
}

TEST(MtlErrors, HaveTheirPlace) {
  const SceneFolder folder;
  const auto errors = [&](const std::string& mtl) {
    folder.write("m.mtl", mtl);
    folder.write("m.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    return folder.errors("m.obj");
  };
  EXPECT_EQ(errors("newmtl m\nKd 1 x 0\n"),
            "m.mtl:2:6: error: this is not a finite number\n    2 | Kd 1 x 0\n      |      ^");
  EXPECT_EQ(errors("newmtl m\nKd 1 1\n"),
            "m.mtl:2:7: error: a number is missing here\n    2 | Kd 1 1\n      |       ^");
  EXPECT_EQ(errors("newmtl m\nNs nan\n"),
            "m.mtl:2:4: error: this is not a finite number\n    2 | Ns nan\n      |    ^");
  EXPECT_EQ(errors("Kd 1 1 1\n"),
            "m.mtl:1:1: error: 'Kd' comes before any 'newmtl'\n    1 | Kd 1 1 1\n      | ^");
  EXPECT_EQ(errors("newmtl m\nmap_Kd -s 2 2 1\n"),
            "m.mtl:2:16: error: the file of 'map_Kd' is missing\n    2 | map_Kd -s 2 2 1\n      |            "
            "    ^");
  folder.write("t.tga", test::tga(1, 1, 255, 255, 255, 255));
  EXPECT_EQ(errors("newmtl m\nKd 1\nmap_Kd -mm 0 2 t.tga\n"),
            "m.mtl:3:16: error: values of map_Kd must lie between 0 and 1, but go from 2 to 2\n"
            "    3 | map_Kd -mm 0 2 t.tga\n      |                ^");
}

}  // namespace
}  // namespace umbral
