namespace StandIns.Graphics;

sealed unsafe class ComputeProgram
{
    internal readonly string Name;
    internal readonly ShaderLayout Layout;
    internal readonly ulong Pipeline;
    internal readonly (uint X, uint Y, uint Z) GroupSize;

    internal ComputeProgram(GpuDevice device, string name, string entry, SpirvModule module)
    {
        Name = name;
        GroupSize = module.GroupSize;
        Layout = new ShaderLayout(device, name, module);
        ulong code = ShaderLayout.CreateModule(device, module);
        using var strings = new NativeStrings();
        var create = new VkComputePipelineCreateInfo
        {
            sType = VkStructureType.ComputePipelineCreateInfo,
            stage = new VkPipelineShaderStageCreateInfo
            {
                sType = VkStructureType.PipelineShaderStageCreateInfo,
                stage = VkShaderStageFlags.Compute,
                module = code,
                pName = strings.Text(entry),
            },
            layout = Layout.Pipeline,
        };
        ulong pipeline;
        Vk.Check(Vk.vkCreateComputePipelines(device.Handle, 0, 1, &create, null, &pipeline), "vkCreateComputePipelines");
        Pipeline = pipeline;
        Vk.vkDestroyShaderModule(device.Handle, code, null);
    }
}
