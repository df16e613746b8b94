"""Renders one reference with Cycles, the path tracer of Blender 3.4. Runs inside Blender; make.sh calls it.

usage: blender -b --factory-startup -P cycles.py -- SCENE.gltf ENVIRONMENT.hdr OUT.hdr WIDTH HEIGHT SAMPLES BOUNCES \
       single|multiple|imported EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG [sky|lamps|sun]

Coordinates of the camera are those of glTF (y is up). The argument before the camera chooses how light scatters between
the facets of a metal: once, or any number of times. With `imported`, all materials stay as the importer makes them
(light scatters any number of times), except where glTF and Weft mean something else: see the functions adapt_.

With `sky`, only the suns and the environment shine; with `lamps`, only lamps and surfaces shine. The sum of both
pictures has all light. Cycles 3.4 chooses one lamp for each sample, so a scene with a sun and many lamps has less noise
this way. With `sun`, only the suns shine.
"""
import math
import sys

import bpy
import numpy
from mathutils import Vector

# The glTF importer of Debian's Blender uses names that newer versions of numpy do not have.
for name, kind in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if name not in numpy.__dict__:
        setattr(numpy, name, kind)


def set_material(material, distribution):
    """D: diffuse without roughness, M: metal, P: Blender's own principled material."""
    tree = material.node_tree
    principled = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    kind = material.name[0]
    if kind == "P":
        principled.distribution = distribution
        return
    bsdf = tree.nodes.new("ShaderNodeBsdfGlossy" if kind == "M" else "ShaderNodeBsdfDiffuse")
    bsdf.inputs["Color"].default_value = principled.inputs["Base Color"].default_value
    if kind == "M":
        bsdf.distribution = distribution
        bsdf.inputs["Roughness"].default_value = principled.inputs["Roughness"].default_value
    else:
        bsdf.inputs["Roughness"].default_value = 0
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    tree.links.new(bsdf.outputs[0], output.inputs["Surface"])


def adapt_material(material):
    """Cuts masks at their threshold, lets the light of lamps pass through glass and water without refraction, and makes
    diffuse light independent of the roughness."""
    tree = material.node_tree
    principled = next((n for n in tree.nodes if n.type == "BSDF_PRINCIPLED"), None)
    if principled is None:
        return
    principled.distribution = "MULTI_GGX"
    alpha = principled.inputs["Alpha"]
    if material.blend_method == "CLIP" and alpha.is_linked:
        cut = tree.nodes.new("ShaderNodeMath")
        cut.operation = "GREATER_THAN"
        tree.links.new(alpha.links[0].from_socket, cut.inputs[0])
        cut.inputs[1].default_value = material.alpha_threshold
        tree.links.new(cut.outputs[0], alpha)
    if principled.inputs["Transmission"].default_value > 0:
        let_shadow_rays_pass(tree, principled)
    else:
        use_lambert(tree, principled)


def source_of(tree, socket):
    """Returns the socket that is linked to an input, or a new node with the value of the input."""
    if socket.is_linked:
        return socket.links[0].from_socket
    node = tree.nodes.new("ShaderNodeRGB" if socket.type == "RGBA" else "ShaderNodeValue")
    node.outputs[0].default_value = socket.default_value
    return node.outputs[0]


def scaled(tree, color, factor):
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = "SCALE"
    tree.links.new(color, node.inputs["Vector"])
    tree.links.new(factor, node.inputs["Scale"])
    return node.outputs["Vector"]


def use_lambert(tree, principled):
    """glTF and Weft have Lambert's diffuse light. Blender's principled material has Burley's, whose rough surfaces send
    up to twice the light back to the source. So a diffuse BSDF gets the base colour of the part that is not metal."""
    color, metallic, alpha = (source_of(tree, principled.inputs[name]) for name in ("Base Color", "Metallic", "Alpha"))
    rest = tree.nodes.new("ShaderNodeMath")
    rest.operation = "SUBTRACT"
    rest.inputs[0].default_value = 1
    tree.links.new(metallic, rest.inputs[1])
    diffuse, both, clear, mix = (tree.nodes.new("ShaderNode" + kind) for kind in (
        "BsdfDiffuse", "AddShader", "BsdfTransparent", "MixShader"))
    tree.links.new(scaled(tree, color, rest.outputs[0]), diffuse.inputs["Color"])
    if principled.inputs["Normal"].is_linked:
        tree.links.new(principled.inputs["Normal"].links[0].from_socket, diffuse.inputs["Normal"])
    for link in principled.inputs["Alpha"].links:
        tree.links.remove(link)
    principled.inputs["Alpha"].default_value = 1
    tree.links.new(scaled(tree, color, metallic), principled.inputs["Base Color"])
    tree.links.new(diffuse.outputs["BSDF"], both.inputs[0])
    tree.links.new(principled.outputs["BSDF"], both.inputs[1])
    tree.links.new(alpha, mix.inputs["Fac"])
    tree.links.new(clear.outputs["BSDF"], mix.inputs[1])
    tree.links.new(both.outputs["Shader"], mix.inputs[2])
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    tree.links.new(mix.outputs["Shader"], output.inputs["Surface"])


def let_shadow_rays_pass(tree, principled):
    """A path tracer cannot find a point lamp or a sun without size through a refracting surface."""
    path, clear, mix = (tree.nodes.new("ShaderNode" + kind) for kind in ("LightPath", "BsdfTransparent", "MixShader"))
    tree.links.new(path.outputs["Is Shadow Ray"], mix.inputs["Fac"])
    tree.links.new(principled.outputs["BSDF"], mix.inputs[1])
    tree.links.new(clear.outputs["BSDF"], mix.inputs[2])
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    tree.links.new(mix.outputs["Shader"], output.inputs["Surface"])


def emits(material):
    node = next((n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"), None)
    emission = node and node.inputs["Emission"]
    return bool(node) and (emission.is_linked or any(emission.default_value[:3])) and \
        node.inputs["Emission Strength"].default_value > 0


def adapt_shades():
    """Surfaces that emit light cast no shadows, because they are around lamps: see docs/lamp-shadows.md."""
    for thing in bpy.data.objects:
        if thing.type == "MESH" and any(m and m.use_nodes and emits(m) for m in thing.data.materials):
            thing.visible_shadow = False


def adapt_lights():
    """Makes lamps and suns as small as those of glTF."""
    for light in bpy.data.lights:
        if light.type == "SUN":
            light.angle = 0
        else:
            light.shadow_soft_size = 0


def keep_lights(which):
    """Removes the light of all other sources."""
    suns = which != "lamps"
    for holder in [o for o in bpy.data.objects if o.type == "LIGHT" and (o.data.type == "SUN") != suns]:
        bpy.data.objects.remove(holder)
    if which != "sky":
        node = next(n for n in bpy.context.scene.world.node_tree.nodes if n.type == "BACKGROUND")
        node.inputs["Strength"].default_value = 0
    if not suns:
        return
    for material in bpy.data.materials:
        for node in material.node_tree.nodes if material.use_nodes else ():
            if node.type == "BSDF_PRINCIPLED":
                node.inputs["Emission Strength"].default_value = 0


def set_environment(scene, path):
    world = bpy.data.worlds.new("World")
    scene.world = world
    world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    output, background = tree.nodes.new("ShaderNodeOutputWorld"), tree.nodes.new("ShaderNodeBackground")
    picture, mapping = tree.nodes.new("ShaderNodeTexEnvironment"), tree.nodes.new("ShaderNodeMapping")
    coordinates = tree.nodes.new("ShaderNodeTexCoord")
    picture.image = bpy.data.images.load(path)
    picture.image.colorspace_settings.name = "Linear"
    mapping.inputs["Rotation"].default_value = (0, 0, -math.pi / 2)  # The middle column is −z of glTF.
    tree.links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], picture.inputs["Vector"])
    tree.links.new(picture.outputs["Color"], background.inputs["Color"])
    tree.links.new(background.outputs[0], output.inputs["Surface"])
    world.cycles.sampling_method = "MANUAL"
    world.cycles.sample_map_resolution = 2048


def set_camera(scene, numbers):
    def to_blender(p):
        return Vector((p[0], -p[2], p[1]))
    eye, at = to_blender(numbers[0:3]), to_blender(numbers[3:6])
    camera = bpy.data.cameras.new("Camera")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = math.radians(numbers[6])
    camera.clip_start, camera.clip_end = 0.01, 1000
    holder = bpy.data.objects.new("Camera", camera)
    holder.location = eye
    holder.rotation_euler = (at - eye).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(holder)
    scene.camera = holder


def set_renderer(scene, out, width, height, samples, bounces):
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.seed = 1
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = bounces
    render = scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
    render.image_settings.file_format = "HDR"
    render.filepath = out
    scene.view_settings.view_transform = "Raw"


def main():
    a = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    # With this mode, 1 lx of the file is 1 W/m², and 1 cd is 1 W/sr. So radiance has the numbers of cd/m².
    bpy.ops.import_scene.gltf(filepath=a[0], convert_lighting_mode="COMPAT")
    adapt_lights()
    adapt_shades()
    for material in bpy.data.materials:
        if not material.use_nodes:
            continue
        if a[7] == "imported":
            adapt_material(material)
        else:
            set_material(material, {"single": "GGX", "multiple": "MULTI_GGX"}[a[7]])
    set_environment(scene, a[1])
    if len(a) > 9:
        keep_lights(a[9])
    set_camera(scene, [float(x) for x in a[8].split(",")])
    set_renderer(scene, a[2], *(int(x) for x in a[3:7]))
    bpy.ops.render.render(write_still=True)


main()
