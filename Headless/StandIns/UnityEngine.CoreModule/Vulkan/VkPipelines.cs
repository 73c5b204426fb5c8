namespace StandIns.Vulkan;

enum VkPrimitiveTopology : int
{
    PointList = 0,
    LineList = 1,
    LineStrip = 2,
    TriangleList = 3,
}

enum VkCompareOp : int
{
    Never = 0,
    Less = 1,
    Equal = 2,
    LessOrEqual = 3,
    Greater = 4,
    NotEqual = 5,
    GreaterOrEqual = 6,
    Always = 7,
}

enum VkBlendFactor : int
{
    Zero = 0,
    One = 1,
    SrcColor = 2,
    OneMinusSrcColor = 3,
    DstColor = 4,
    OneMinusDstColor = 5,
    SrcAlpha = 6,
    OneMinusSrcAlpha = 7,
    DstAlpha = 8,
    OneMinusDstAlpha = 9,
    SrcAlphaSaturate = 14,
}

enum VkBlendOp : int
{
    Add = 0,
    Subtract = 1,
    ReverseSubtract = 2,
    Min = 3,
    Max = 4,
}

[Flags]
enum VkCullModeFlags : uint
{
    None = 0,
    Front = 1,
    Back = 2,
}

enum VkFrontFace : int
{
    CounterClockwise = 0,
    Clockwise = 1,
}

enum VkDynamicState : int
{
    Viewport = 0,
    Scissor = 1,
}

unsafe struct VkShaderModuleCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public UIntPtr codeSize;
    public uint* pCode;
}

unsafe struct VkPipelineShaderStageCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkShaderStageFlags stage;
    public ulong module;
    public byte* pName;
    public void* pSpecializationInfo;
}

unsafe struct VkComputePipelineCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkPipelineShaderStageCreateInfo stage;
    public ulong layout;
    public ulong basePipelineHandle;
    public int basePipelineIndex;
}

unsafe struct VkPipelineVertexInputStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint vertexBindingDescriptionCount;
    public void* pVertexBindingDescriptions;
    public uint vertexAttributeDescriptionCount;
    public void* pVertexAttributeDescriptions;
}

unsafe struct VkPipelineInputAssemblyStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public VkPrimitiveTopology topology;
    public uint primitiveRestartEnable;
}

unsafe struct VkPipelineViewportStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint viewportCount;
    public VkViewport* pViewports;
    public uint scissorCount;
    public VkRect2D* pScissors;
}

unsafe struct VkPipelineRasterizationStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint depthClampEnable;
    public uint rasterizerDiscardEnable;
    public uint polygonMode;
    public VkCullModeFlags cullMode;
    public VkFrontFace frontFace;
    public uint depthBiasEnable;
    public float depthBiasConstantFactor;
    public float depthBiasClamp;
    public float depthBiasSlopeFactor;
    public float lineWidth;
}

unsafe struct VkPipelineMultisampleStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint rasterizationSamples;
    public uint sampleShadingEnable;
    public float minSampleShading;
    public uint* pSampleMask;
    public uint alphaToCoverageEnable;
    public uint alphaToOneEnable;
}

unsafe struct VkStencilOpState
{
    public uint failOp;
    public uint passOp;
    public uint depthFailOp;
    public VkCompareOp compareOp;
    public uint compareMask;
    public uint writeMask;
    public uint reference;
}

unsafe struct VkPipelineDepthStencilStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint depthTestEnable;
    public uint depthWriteEnable;
    public VkCompareOp depthCompareOp;
    public uint depthBoundsTestEnable;
    public uint stencilTestEnable;
    public VkStencilOpState front;
    public VkStencilOpState back;
    public float minDepthBounds;
    public float maxDepthBounds;
}

unsafe struct VkPipelineColorBlendAttachmentState
{
    public uint blendEnable;
    public VkBlendFactor srcColorBlendFactor;
    public VkBlendFactor dstColorBlendFactor;
    public VkBlendOp colorBlendOp;
    public VkBlendFactor srcAlphaBlendFactor;
    public VkBlendFactor dstAlphaBlendFactor;
    public VkBlendOp alphaBlendOp;
    public uint colorWriteMask;
}

unsafe struct VkPipelineColorBlendStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint logicOpEnable;
    public uint logicOp;
    public uint attachmentCount;
    public VkPipelineColorBlendAttachmentState* pAttachments;
    public fixed float blendConstants[4];
}

unsafe struct VkPipelineDynamicStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint dynamicStateCount;
    public VkDynamicState* pDynamicStates;
}

unsafe struct VkPipelineRenderingCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint viewMask;
    public uint colorAttachmentCount;
    public VkFormat* pColorAttachmentFormats;
    public VkFormat depthAttachmentFormat;
    public VkFormat stencilAttachmentFormat;
}

unsafe struct VkGraphicsPipelineCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags;
    public uint stageCount;
    public VkPipelineShaderStageCreateInfo* pStages;
    public VkPipelineVertexInputStateCreateInfo* pVertexInputState;
    public VkPipelineInputAssemblyStateCreateInfo* pInputAssemblyState;
    public void* pTessellationState;
    public VkPipelineViewportStateCreateInfo* pViewportState;
    public VkPipelineRasterizationStateCreateInfo* pRasterizationState;
    public VkPipelineMultisampleStateCreateInfo* pMultisampleState;
    public VkPipelineDepthStencilStateCreateInfo* pDepthStencilState;
    public VkPipelineColorBlendStateCreateInfo* pColorBlendState;
    public VkPipelineDynamicStateCreateInfo* pDynamicState;
    public ulong layout;
    public ulong renderPass;
    public uint subpass;
    public ulong basePipelineHandle;
    public int basePipelineIndex;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern VkResult vkCreateShaderModule(IntPtr device, VkShaderModuleCreateInfo* pCreateInfo,
        void* pAllocator, ulong* pShaderModule);

    [DllImport(Library)]
    internal static extern void vkDestroyShaderModule(IntPtr device, ulong shaderModule, void* pAllocator);

    [DllImport(Library)]
    internal static extern VkResult vkCreateComputePipelines(IntPtr device, ulong pipelineCache, uint createInfoCount,
        VkComputePipelineCreateInfo* pCreateInfos, void* pAllocator, ulong* pPipelines);

    [DllImport(Library)]
    internal static extern VkResult vkCreateGraphicsPipelines(IntPtr device, ulong pipelineCache, uint createInfoCount,
        VkGraphicsPipelineCreateInfo* pCreateInfos, void* pAllocator, ulong* pPipelines);
}
