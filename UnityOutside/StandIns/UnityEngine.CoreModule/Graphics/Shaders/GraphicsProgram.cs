namespace StandIns.Graphics;

sealed unsafe class GraphicsProgram(GpuDevice device, string name, SpirvModule vertex, string vertexEntry,
    SpirvModule fragment, string fragmentEntry)
{
    internal readonly string Name = name;
    internal readonly ShaderLayout Layout = new ShaderLayout(device, name, vertex, fragment);
    readonly GpuDevice m_device = device;
    readonly ulong m_vertex = ShaderLayout.CreateModule(device, vertex);
    readonly ulong m_fragment = ShaderLayout.CreateModule(device, fragment);
    readonly string m_vertexEntry = vertexEntry;
    readonly string m_fragmentEntry = fragmentEntry;
    readonly Dictionary<PipelineKey, ulong> m_pipelines = new Dictionary<PipelineKey, ulong>();

    internal ulong Pipeline(in PipelineKey key)
    {
        if (!m_pipelines.TryGetValue(key, out ulong pipeline))
            m_pipelines.Add(key, pipeline = Create(key));
        return pipeline;
    }

    ulong Create(in PipelineKey key)
    {
        using var strings = new NativeStrings();
        VkPipelineShaderStageCreateInfo* stages = stackalloc VkPipelineShaderStageCreateInfo[2];
        stages[0] = Stage(VkShaderStageFlags.Vertex, m_vertex, strings.Text(m_vertexEntry));
        stages[1] = Stage(VkShaderStageFlags.Fragment, m_fragment, strings.Text(m_fragmentEntry));
        var vertices = new VkPipelineVertexInputStateCreateInfo { sType = VkStructureType.PipelineVertexInputStateCreateInfo };
        var assembly = new VkPipelineInputAssemblyStateCreateInfo
        {
            sType = VkStructureType.PipelineInputAssemblyStateCreateInfo,
            topology = key.Topology,
        };
        var viewport = new VkPipelineViewportStateCreateInfo
        {
            sType = VkStructureType.PipelineViewportStateCreateInfo,
            viewportCount = 1,
            scissorCount = 1,
        };
        var raster = Raster(key.State);
        var samples = new VkPipelineMultisampleStateCreateInfo
        {
            sType = VkStructureType.PipelineMultisampleStateCreateInfo,
            rasterizationSamples = 1,
        };
        var depth = Depth(key);
        VkPipelineColorBlendAttachmentState* blends = stackalloc VkPipelineColorBlendAttachmentState[RenderTargets.MaxColors];
        VkFormat* formats = stackalloc VkFormat[RenderTargets.MaxColors];
        for (int i = 0; i < key.ColorCount; i++)
        {
            blends[i] = Blend(key.State);
            formats[i] = key.Color(i);
        }
        var blend = new VkPipelineColorBlendStateCreateInfo
        {
            sType = VkStructureType.PipelineColorBlendStateCreateInfo,
            attachmentCount = (uint)key.ColorCount,
            pAttachments = blends,
        };
        VkDynamicState* changing = stackalloc VkDynamicState[] { VkDynamicState.Viewport, VkDynamicState.Scissor };
        var dynamic = new VkPipelineDynamicStateCreateInfo
        {
            sType = VkStructureType.PipelineDynamicStateCreateInfo,
            dynamicStateCount = 2,
            pDynamicStates = changing,
        };
        var rendering = new VkPipelineRenderingCreateInfo
        {
            sType = VkStructureType.PipelineRenderingCreateInfo,
            colorAttachmentCount = (uint)key.ColorCount,
            pColorAttachmentFormats = formats,
            depthAttachmentFormat = key.Depth,
        };
        var create = new VkGraphicsPipelineCreateInfo
        {
            sType = VkStructureType.GraphicsPipelineCreateInfo,
            pNext = &rendering,
            stageCount = 2,
            pStages = stages,
            pVertexInputState = &vertices,
            pInputAssemblyState = &assembly,
            pViewportState = &viewport,
            pRasterizationState = &raster,
            pMultisampleState = &samples,
            pDepthStencilState = &depth,
            pColorBlendState = &blend,
            pDynamicState = &dynamic,
            layout = Layout.Pipeline,
        };
        ulong pipeline;
        Vk.Check(Vk.vkCreateGraphicsPipelines(m_device.Handle, 0, 1, &create, null, &pipeline), "vkCreateGraphicsPipelines");
        return pipeline;
    }

    static VkPipelineShaderStageCreateInfo Stage(VkShaderStageFlags stage, ulong module, byte* entry) =>
        new VkPipelineShaderStageCreateInfo
        {
            sType = VkStructureType.PipelineShaderStageCreateInfo,
            stage = stage,
            module = module,
            pName = entry,
        };

    // Unity's front is clockwise; what is drawn into a texture is upside down, and so the other way round.
    static VkPipelineRasterizationStateCreateInfo Raster(in FixedState state) => new VkPipelineRasterizationStateCreateInfo
    {
        sType = VkStructureType.PipelineRasterizationStateCreateInfo,
        cullMode = state.Cull,
        frontFace = VkFrontFace.CounterClockwise,
        lineWidth = 1,
    };

    static VkPipelineDepthStencilStateCreateInfo Depth(in PipelineKey key) => new VkPipelineDepthStencilStateCreateInfo
    {
        sType = VkStructureType.PipelineDepthStencilStateCreateInfo,
        depthTestEnable = key.Depth != VkFormat.Undefined ? 1u : 0,
        depthWriteEnable = key.State.WritesDepth ? 1u : 0,
        depthCompareOp = key.State.DepthTest,
    };

    static VkPipelineColorBlendAttachmentState Blend(in FixedState state) => new VkPipelineColorBlendAttachmentState
    {
        blendEnable = state.Blends ? 1u : 0,
        srcColorBlendFactor = state.SourceColor,
        dstColorBlendFactor = state.TargetColor,
        colorBlendOp = state.ColorOperation,
        srcAlphaBlendFactor = state.SourceAlpha,
        dstAlphaBlendFactor = state.TargetAlpha,
        alphaBlendOp = state.AlphaOperation,
        colorWriteMask = state.ColorMask,
    };
}
