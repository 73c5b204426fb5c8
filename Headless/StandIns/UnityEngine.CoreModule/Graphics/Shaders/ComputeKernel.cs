namespace StandIns.Graphics
{
    /// <summary>One kernel of a compute shader and its variants, each compiled when it is first run.</summary>
    sealed unsafe class ComputeKernel
    {
        internal readonly string Name;
        /// <summary>The buffers and textures that are set for this kernel.</summary>
        internal readonly PropertySheet Sheet = new PropertySheet();
        readonly ComputeSource m_source;
        readonly Dictionary<long, ComputeProgram> m_programs = new Dictionary<long, ComputeProgram>();

        internal ComputeKernel(ComputeSource source, string name)
        {
            m_source = source;
            Name = name;
        }

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
}
