namespace StandIns.Graphics;

sealed unsafe class ComputeKernel(ComputeSource source, string name)
{
    internal readonly string Name = name;
    internal readonly PropertySheet Sheet = new PropertySheet();
    readonly ComputeSource m_source = source;
    readonly Dictionary<long, ComputeProgram> m_programs = new Dictionary<long, ComputeProgram>();

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
