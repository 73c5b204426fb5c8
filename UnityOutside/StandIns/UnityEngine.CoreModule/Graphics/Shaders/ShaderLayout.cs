namespace StandIns.Graphics;

sealed unsafe class ShaderLayout
{
    const int MaxResources = 32; // What every device takes by vkCmdPushDescriptorSetKHR.

    internal readonly ShaderResource[] Resources;
    internal readonly PipelineLayout Pipeline;

    internal ShaderLayout(GpuDevice device, string name, params SpirvModule[] stages)
    {
        var resources = new List<ShaderResource>();
        foreach (SpirvModule stage in stages)
            foreach (ShaderResource resource in stage.Resources())
            {
                ShaderResource same = resources.Find(r =>
                    r.NameId == resource.NameId && r.Kind != DescriptorType.UniformBuffer);
                if (same != null && same.Kind != resource.Kind)
                    throw new InvalidOperationException($"{name}: {resource.Name} is not the same kind of thing in both "
                        + $"stages");
                if (same == null)
                {
                    resource.Binding = resources.Count;
                    resources.Add(resource);
                }
                stage.SetBinding(resource, (same ?? resource).Binding);
            }
        if (resources.Count > MaxResources)
            throw new InvalidOperationException($"{name}: names {resources.Count} resources, {MaxResources} are supported");
        Resources = resources.ToArray();
        Pipeline = Create(device);
    }

    /// <summary>A module as Vulkan wants it, when its bindings are set.</summary>
    internal static ShaderModule CreateModule(GpuDevice device, SpirvModule module)
    {
        fixed (uint* words = module.Words)
        {
            var create = new ShaderModuleCreateInfo(codeSize: (UIntPtr)(module.Words.Length * 4), pCode: words);
            ShaderModule handle;
            Check(Api.CreateShaderModule(device.Handle, &create, null, &handle), "vkCreateShaderModule");
            return handle;
        }
    }

    PipelineLayout Create(GpuDevice device)
    {
        DescriptorSetLayoutBinding[] bindings = Resources.Select(r => new DescriptorSetLayoutBinding((uint)r.Binding, r.Kind, 1,
            ShaderStageFlags.VertexBit | ShaderStageFlags.FragmentBit | ShaderStageFlags.ComputeBit)).ToArray();
        fixed (DescriptorSetLayoutBinding* first = bindings)
        {
            var create = new DescriptorSetLayoutCreateInfo(flags: DescriptorSetLayoutCreateFlags.PushDescriptorBitKhr,
                bindingCount: (uint)bindings.Length, pBindings: first);
            DescriptorSetLayout set;
            Check(Api.CreateDescriptorSetLayout(device.Handle, &create, null, &set), "vkCreateDescriptorSetLayout");
            var pipeline = new PipelineLayoutCreateInfo(setLayoutCount: 1, pSetLayouts: &set);
            PipelineLayout layout;
            Check(Api.CreatePipelineLayout(device.Handle, &pipeline, null, &layout), "vkCreatePipelineLayout");
            return layout;
        }
    }
}
