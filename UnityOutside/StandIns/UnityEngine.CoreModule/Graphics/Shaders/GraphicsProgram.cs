namespace StandIns.Graphics;

sealed unsafe class GraphicsProgram(GpuDevice device, string name, SpirvModule vertex, string vertexEntry,
    SpirvModule fragment, string fragmentEntry)
{
    internal readonly string Name = name;
    internal readonly ShaderLayout Layout = new ShaderLayout(device, name, vertex, fragment);
    readonly GpuDevice m_device = device;
    readonly ShaderModule m_vertex = ShaderLayout.CreateModule(device, vertex);
    readonly ShaderModule m_fragment = ShaderLayout.CreateModule(device, fragment);
    readonly string m_vertexEntry = vertexEntry;
    readonly string m_fragmentEntry = fragmentEntry;
    readonly Dictionary<PipelineKey, Pipeline> m_pipelines = new Dictionary<PipelineKey, Pipeline>();

    internal Pipeline Pipeline(in PipelineKey key)
    {
        if (!m_pipelines.TryGetValue(key, out Pipeline pipeline))
            m_pipelines.Add(key, pipeline = Create(key));
        return pipeline;
    }

    Pipeline Create(in PipelineKey key)
    {
        using GlobalMemory vertex = SilkMarshal.StringToMemory(m_vertexEntry);
        using GlobalMemory fragment = SilkMarshal.StringToMemory(m_fragmentEntry);
        PipelineShaderStageCreateInfo* stages = stackalloc PipelineShaderStageCreateInfo[2];
        stages[0] = Stage(ShaderStageFlags.VertexBit, m_vertex, vertex.AsPtr<byte>());
        stages[1] = Stage(ShaderStageFlags.FragmentBit, m_fragment, fragment.AsPtr<byte>());
        var vertices = new PipelineVertexInputStateCreateInfo(pNext: null);
        var assembly = new PipelineInputAssemblyStateCreateInfo(topology: key.Topology);
        var viewport = new PipelineViewportStateCreateInfo(viewportCount: 1, scissorCount: 1);
        var raster = Raster(key.State);
        var samples = new PipelineMultisampleStateCreateInfo(rasterizationSamples: SampleCountFlags.Count1Bit);
        var depth = Depth(key);
        PipelineColorBlendAttachmentState* blends = stackalloc PipelineColorBlendAttachmentState[RenderTargets.MaxColors];
        Format* formats = stackalloc Format[RenderTargets.MaxColors];
        for (int i = 0; i < key.ColorCount; i++)
        {
            blends[i] = Blend(key.State);
            formats[i] = key.Color(i);
        }
        var blend = new PipelineColorBlendStateCreateInfo(attachmentCount: (uint)key.ColorCount, pAttachments: blends);
        DynamicState* changing = stackalloc DynamicState[] { DynamicState.Viewport, DynamicState.Scissor };
        var dynamic = new PipelineDynamicStateCreateInfo(dynamicStateCount: 2, pDynamicStates: changing);
        var rendering = new PipelineRenderingCreateInfo(colorAttachmentCount: (uint)key.ColorCount,
            pColorAttachmentFormats: formats, depthAttachmentFormat: key.Depth);
        var create = new GraphicsPipelineCreateInfo(pNext: &rendering, stageCount: 2, pStages: stages,
            pVertexInputState: &vertices, pInputAssemblyState: &assembly, pViewportState: &viewport,
            pRasterizationState: &raster, pMultisampleState: &samples, pDepthStencilState: &depth, pColorBlendState: &blend,
            pDynamicState: &dynamic, layout: Layout.Pipeline);
        Pipeline pipeline;
        Check(Api.CreateGraphicsPipelines(m_device.Handle, default, 1, &create, null, &pipeline), "vkCreateGraphicsPipelines");
        return pipeline;
    }

    static PipelineShaderStageCreateInfo Stage(ShaderStageFlags stage, ShaderModule module, byte* entry) =>
        new PipelineShaderStageCreateInfo(stage: stage, module: module, pName: entry);

    // Unity's front is clockwise; what is drawn into a texture is upside down, and so the other way round.
    static PipelineRasterizationStateCreateInfo Raster(in FixedState state) => new PipelineRasterizationStateCreateInfo(
        cullMode: state.Cull, frontFace: FrontFace.CounterClockwise, lineWidth: 1);

    static PipelineDepthStencilStateCreateInfo Depth(in PipelineKey key) => new PipelineDepthStencilStateCreateInfo(
        depthTestEnable: key.Depth != Format.Undefined ? 1u : 0, depthWriteEnable: key.State.WritesDepth ? 1u : 0,
        depthCompareOp: key.State.DepthTest);

    static PipelineColorBlendAttachmentState Blend(in FixedState state) => new PipelineColorBlendAttachmentState
    {
        BlendEnable = state.Blends ? 1u : 0,
        SrcColorBlendFactor = state.SourceColor,
        DstColorBlendFactor = state.TargetColor,
        ColorBlendOp = state.ColorOperation,
        SrcAlphaBlendFactor = state.SourceAlpha,
        DstAlphaBlendFactor = state.TargetAlpha,
        AlphaBlendOp = state.AlphaOperation,
        ColorWriteMask = (ColorComponentFlags)state.ColorMask,
    };
}
