# Renders a scene file of matte meshes under rectangular lamps in Blender's Cycles, without any of its biases.
#
# blender --background --factory-startup --python render_in_cycles.py -- SCENE WIDTHxHEIGHT THREADS SAMPLES,SAMPLES… FIRST:LAST PREFIX
#
# One process renders all of them, after one that is thrown away. For each: PREFIX-SAMPLES-SEED.exr and a line "rendered SAMPLES SEED
# CPU_SECONDS", synchronisation and file included.
import math
import resource
import sys
import tomllib

import bpy
import mathutils


# Cycles lifts rays off surfaces by lengths that suit rooms of metres: in the Cornell box in millimetres its direct light is up
# to 0.5 % too dark. Lamps are its area lights: light from a mesh that emits is up to 3 % too dark where it leaves grazing.
metres = 0.01


def matte(name, reflectance):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*colour(reflectance), 1)
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
    return material


def colour(value):
    return [value] * 3 if isinstance(value, (int, float)) else list(value)


def point(values):
    return metres * mathutils.Vector(values)


def add_object(name, data):
    placed = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(placed)
    return placed


def add_mesh(shape, materials):
    material = materials[shape["material"]]
    if shape["type"] != "mesh" or material["type"] != "matte":
        sys.exit(f"render_in_cycles: a {shape['type']} that is {material['type']} is not known here")
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata([point(p) for p in shape["vertices"]], [], shape["faces"])
    mesh.materials.append(matte(shape["material"], material["reflectance"]))
    add_object("mesh", mesh)


def add_lamp(shape):
    """A rectangle that shines to one side and reflects nothing. Cycles: L = power / (4 area)."""
    u, v = point(shape["edge_u"]), point(shape["edge_v"])
    shines_to = u.cross(v).normalized()
    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.shape, lamp.size, lamp.size_y = "RECTANGLE", u.length, v.length
    lamp.color, lamp.energy = colour(shape["emission"]), 4 * u.length * v.length
    x, z = u.normalized(), -shines_to
    frame = mathutils.Matrix([x, z.cross(x), z]).transposed().to_4x4()
    placed = add_object("lamp", lamp)
    placed.matrix_world = mathutils.Matrix.Translation(point(shape["origin"]) + (u + v) / 2) @ frame
    placed.visible_camera = True


def add_camera(camera):
    position, target = point(camera["position"]), point(camera["look_at"])
    backward = (position - target).normalized()
    right = mathutils.Vector(camera.get("up", [0, 1, 0])).cross(backward).normalized()
    frame = mathutils.Matrix([right, backward.cross(right), backward]).transposed().to_4x4()
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    lens.angle = math.radians(camera["fov"])
    lens.clip_start, lens.clip_end = 1e-3, 1e6
    eye = add_object("camera", lens)
    eye.matrix_world = mathutils.Matrix.Translation(position) @ frame
    bpy.context.scene.camera = eye


def settle(scene, width, height, threads):
    """Nothing clamped, cut off, blurred, denoised or stopped early: the same equation as ours."""
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.use_persistent_data = True
    scene.world.use_nodes = False
    scene.world.color = (0, 0, 0)
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.light_sampling_threshold = 0
    cycles.blur_glossy = 0
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = 1024


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def render(scene, samples, seed, path):
    scene.cycles.samples, scene.cycles.seed = samples, seed
    scene.render.filepath = path
    start = cpu_seconds()
    bpy.ops.render.render(write_still=True)
    return cpu_seconds() - start


def main():
    file, size, threads, samples, seeds, prefix = sys.argv[sys.argv.index("--") + 1:]
    with open(file, "rb") as f:
        described = tomllib.load(f)
    width, height = (int(n) for n in size.split("x"))
    first, last = (int(n) for n in seeds.split(":"))
    bpy.ops.wm.read_homefile(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("black")
    for shape in described["shapes"]:
        add_lamp(shape) if "emission" in shape else add_mesh(shape, described["materials"])
    add_camera(described["camera"])
    settle(scene, width, height, int(threads))
    render(scene, 1, 0, f"{prefix}-warm-up.exr")
    for spp in samples.split(","):
        for seed in range(first, last + 1):
            seconds = render(scene, int(spp), seed, f"{prefix}-{spp}-{seed}.exr")
            print("rendered", spp, seed, seconds, flush=True)


main()
