"""Renders one reference with Cycles, the path tracer of Blender 3.4. Runs inside Blender; make.sh calls it.

usage: blender -b --factory-startup -P cycles.py -- SCENE.gltf ENVIRONMENT.hdr OUT.hdr WIDTH HEIGHT SAMPLES BOUNCES \
       single|multiple EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG

Coordinates of the camera are those of glTF (y is up). The last but one argument chooses how light scatters between
the facets of a metal: once, or any number of times.
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
    bpy.ops.import_scene.gltf(filepath=a[0])
    distribution = {"single": "GGX", "multiple": "MULTI_GGX"}[a[7]]
    for material in bpy.data.materials:
        if material.use_nodes:
            set_material(material, distribution)
    set_environment(scene, a[1])
    set_camera(scene, [float(x) for x in a[8].split(",")])
    set_renderer(scene, a[2], *(int(x) for x in a[3:7]))
    bpy.ops.render.render(write_still=True)


main()
