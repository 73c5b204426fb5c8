namespace StandIns.Graphics;

sealed unsafe class ComputeProgram
{
    internal readonly string Name;
    internal readonly ShaderLayout Layout;
    internal readonly Pipeline Pipeline;

    internal ComputeProgram(GpuDevice device, string name, string entry, SpirvModule module)
    {
        Name = name;
        Layout = new ShaderLayout(device, name, module);
        ShaderModule code = ShaderLayout.CreateModule(device, module);
        using GlobalMemory entryName = SilkMarshal.StringToMemory(entry);
        var stage = new PipelineShaderStageCreateInfo(stage: ShaderStageFlags.ComputeBit, module: code,
            pName: entryName.AsPtr<byte>());
        var create = new ComputePipelineCreateInfo(stage: stage, layout: Layout.Pipeline);
        Pipeline pipeline;
        Check(Api.CreateComputePipelines(device.Handle, default, 1, &create, null, &pipeline), "vkCreateComputePipelines");
        Pipeline = pipeline;
        Api.DestroyShaderModule(device.Handle, code, null);
    }
}
