namespace StandIns.Graphics;

sealed unsafe class ShaderLayout
{
    // What every device takes by vkCmdPushDescriptorSetKHR.
    const int MaxResources = 32;

    internal readonly ShaderResource[] Resources;
    internal readonly ulong Pipeline;

    internal ShaderLayout(GpuDevice device, string name, params SpirvModule[] stages)
    {
        var resources = new List<ShaderResource>();
        foreach (SpirvModule stage in stages)
            foreach (ShaderResource resource in stage.Resources())
            {
                ShaderResource same = resources.Find(r =>
                    r.NameId == resource.NameId && r.Kind != VkDescriptorType.UniformBuffer);
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
    internal static ulong CreateModule(GpuDevice device, SpirvModule module)
    {
        fixed (uint* words = module.Words)
        {
            var create = new VkShaderModuleCreateInfo
            {
                sType = VkStructureType.ShaderModuleCreateInfo,
                codeSize = (UIntPtr)(module.Words.Length * 4),
                pCode = words,
            };
            ulong handle;
            Vk.Check(Vk.vkCreateShaderModule(device.Handle, &create, null, &handle), "vkCreateShaderModule");
            return handle;
        }
    }

    ulong Create(GpuDevice device)
    {
        VkDescriptorSetLayoutBinding[] bindings = Resources.Select(r => new VkDescriptorSetLayoutBinding
        {
            binding = (uint)r.Binding,
            descriptorType = r.Kind,
            descriptorCount = 1,
            stageFlags = VkShaderStageFlags.Vertex | VkShaderStageFlags.Fragment | VkShaderStageFlags.Compute,
        }).ToArray();
        fixed (VkDescriptorSetLayoutBinding* first = bindings)
        {
            const uint isPushed = 1;
            var create = new VkDescriptorSetLayoutCreateInfo
            {
                sType = VkStructureType.DescriptorSetLayoutCreateInfo,
                flags = isPushed,
                bindingCount = (uint)bindings.Length,
                pBindings = first,
            };
            ulong set;
            Vk.Check(Vk.vkCreateDescriptorSetLayout(device.Handle, &create, null, &set), "vkCreateDescriptorSetLayout");
            var pipeline = new VkPipelineLayoutCreateInfo
            {
                sType = VkStructureType.PipelineLayoutCreateInfo,
                setLayoutCount = 1,
                pSetLayouts = &set,
            };
            ulong layout;
            Vk.Check(Vk.vkCreatePipelineLayout(device.Handle, &pipeline, null, &layout), "vkCreatePipelineLayout");
            return layout;
        }
    }
}
