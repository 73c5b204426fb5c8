namespace StandIns.Vulkan;

enum VkDescriptorType : int { Sampler = 0, SampledImage = 2, StorageImage = 3, UniformBuffer = 6, StorageBuffer = 7 }

[Flags]
enum VkShaderStageFlags : uint { Vertex = 1, Fragment = 16, Compute = 32 }

unsafe struct VkDescriptorSetLayoutBinding
{
    public uint binding;
    public VkDescriptorType descriptorType;
    public uint descriptorCount;
    public VkShaderStageFlags stageFlags;
    public ulong* pImmutableSamplers;
}

unsafe struct VkDescriptorSetLayoutCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, bindingCount;
    public VkDescriptorSetLayoutBinding* pBindings;
}

unsafe struct VkPipelineLayoutCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, setLayoutCount;
    public ulong* pSetLayouts;
    public uint pushConstantRangeCount;
    public void* pPushConstantRanges;
}

unsafe struct VkDescriptorBufferInfo
{
    public ulong buffer, offset, range;
}

unsafe struct VkDescriptorImageInfo
{
    public ulong sampler, imageView;
    public VkImageLayout imageLayout;
}

unsafe struct VkWriteDescriptorSet
{
    public VkStructureType sType;
    public void* pNext;
    public ulong dstSet;
    public uint dstBinding, dstArrayElement, descriptorCount;
    public VkDescriptorType descriptorType;
    public VkDescriptorImageInfo* pImageInfo;
    public VkDescriptorBufferInfo* pBufferInfo;
    public ulong* pTexelBufferView;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern VkResult vkCreateDescriptorSetLayout(IntPtr device,
        VkDescriptorSetLayoutCreateInfo* pCreateInfo, void* pAllocator, ulong* pSetLayout);
    [DllImport(Library)]
    internal static extern VkResult vkCreatePipelineLayout(IntPtr device, VkPipelineLayoutCreateInfo* pCreateInfo,
        void* pAllocator, ulong* pPipelineLayout);
}
