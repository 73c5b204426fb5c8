namespace StandIns.Vulkan;

enum VkPrimitiveTopology : int { PointList = 0, LineList = 1, LineStrip = 2, TriangleList = 3 }

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

enum VkBlendOp : int { Add = 0, Subtract = 1, ReverseSubtract = 2, Min = 3, Max = 4 }

[Flags]
enum VkCullModeFlags : uint { None = 0, Front = 1, Back = 2 }

enum VkFrontFace : int { CounterClockwise = 0, Clockwise = 1 }

enum VkDynamicState : int { Viewport = 0, Scissor = 1 }

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
    public ulong layout, basePipelineHandle;
    public int basePipelineIndex;
}

unsafe struct VkPipelineVertexInputStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, vertexBindingDescriptionCount;
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
    public uint flags, viewportCount;
    public VkViewport* pViewports;
    public uint scissorCount;
    public VkRect2D* pScissors;
}

unsafe struct VkPipelineRasterizationStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, depthClampEnable, rasterizerDiscardEnable, polygonMode;
    public VkCullModeFlags cullMode;
    public VkFrontFace frontFace;
    public uint depthBiasEnable;
    public float depthBiasConstantFactor, depthBiasClamp, depthBiasSlopeFactor, lineWidth;
}

unsafe struct VkPipelineMultisampleStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, rasterizationSamples, sampleShadingEnable;
    public float minSampleShading;
    public uint* pSampleMask;
    public uint alphaToCoverageEnable, alphaToOneEnable;
}

unsafe struct VkStencilOpState
{
    public uint failOp, passOp, depthFailOp;
    public VkCompareOp compareOp;
    public uint compareMask, writeMask, reference;
}

unsafe struct VkPipelineDepthStencilStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, depthTestEnable, depthWriteEnable;
    public VkCompareOp depthCompareOp;
    public uint depthBoundsTestEnable, stencilTestEnable;
    public VkStencilOpState front, back;
    public float minDepthBounds, maxDepthBounds;
}

unsafe struct VkPipelineColorBlendAttachmentState
{
    public uint blendEnable;
    public VkBlendFactor srcColorBlendFactor, dstColorBlendFactor;
    public VkBlendOp colorBlendOp;
    public VkBlendFactor srcAlphaBlendFactor, dstAlphaBlendFactor;
    public VkBlendOp alphaBlendOp;
    public uint colorWriteMask;
}

unsafe struct VkPipelineColorBlendStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, logicOpEnable, logicOp, attachmentCount;
    public VkPipelineColorBlendAttachmentState* pAttachments;
    public fixed float blendConstants[4];
}

unsafe struct VkPipelineDynamicStateCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, dynamicStateCount;
    public VkDynamicState* pDynamicStates;
}

unsafe struct VkPipelineRenderingCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint viewMask, colorAttachmentCount;
    public VkFormat* pColorAttachmentFormats;
    public VkFormat depthAttachmentFormat, stencilAttachmentFormat;
}

unsafe struct VkGraphicsPipelineCreateInfo
{
    public VkStructureType sType;
    public void* pNext;
    public uint flags, stageCount;
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
    public ulong layout, renderPass;
    public uint subpass;
    public ulong basePipelineHandle;
    public int basePipelineIndex;
}

static unsafe partial class Vk
{
    [DllImport(Library)]
    internal static extern VkResult vkCreateShaderModule(IntPtr device, VkShaderModuleCreateInfo* pCreateInfo,
        void* pAllocator, ulong* pShaderModule);
    [DllImport(Library)] internal static extern void vkDestroyShaderModule(IntPtr device, ulong shaderModule, void* pAllocator);
    [DllImport(Library)]
    internal static extern VkResult vkCreateComputePipelines(IntPtr device, ulong pipelineCache, uint createInfoCount,
        VkComputePipelineCreateInfo* pCreateInfos, void* pAllocator, ulong* pPipelines);
    [DllImport(Library)]
    internal static extern VkResult vkCreateGraphicsPipelines(IntPtr device, ulong pipelineCache, uint createInfoCount,
        VkGraphicsPipelineCreateInfo* pCreateInfos, void* pAllocator, ulong* pPipelines);
}
