namespace StandIns.Graphics;

/// <summary>One kernel of a compute shader and its variants, each compiled when it is first run.</summary>
sealed unsafe class ComputeKernel(ComputeSource source, string name)
{
    internal readonly string Name = name;
    /// <summary>The buffers and textures that are set for this kernel.</summary>
    internal readonly PropertySheet Sheet = new PropertySheet();
    readonly ComputeSource m_source = source;
    readonly Dictionary<long, ComputeProgram> m_programs = new Dictionary<long, ComputeProgram>();

    /// <exception cref="InvalidOperationException">It does not compile.</exception>
    internal ComputeProgram Program(KeywordSet local)
    {
        long variant = KeywordVariant.Choose(m_source.Keywords, local);
        if (!m_programs.TryGetValue(variant, out ComputeProgram program))
            m_programs.Add(variant, program = Compile(variant));
        return program;
    }

    ComputeProgram Compile(long variant) => new ComputeProgram(GpuDevice.Current, m_source.Name + ", " + Name, Name,
        SpirvModule.For(GpuDevice.Current, m_source.Kernel(Name, variant).Compile()));
}
