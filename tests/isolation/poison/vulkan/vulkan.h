#error "this module must build without Vulkan headers"
