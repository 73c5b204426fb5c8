namespace StandIns.Graphics
{
    /// <summary>One stage of one variant of a shader, or a kernel: what a compiler is given.</summary>
    sealed class ShaderStage
    {
        internal readonly ShaderFiles Files;
        /// <summary>The shader and its pass, or the compute file: how messages name it.</summary>
        internal readonly string Name;
        /// <summary>HLSL with its pragmas, without what it includes.</summary>
        internal readonly string Source;
        /// <summary>As glslang calls it: vert, frag, comp.</summary>
        internal readonly string Stage;
        internal readonly string Entry;
        internal readonly string[] Keywords;

        internal ShaderStage(ShaderFiles files, string name, string source, string stage, string entry, string[] keywords)
        {
            Files = files;
            Name = name;
            Source = source;
            Stage = stage;
            Entry = entry;
            Keywords = keywords;
        }

        /// <summary>SPIR-V, made without a device.</summary>
        /// <exception cref="System.InvalidOperationException">It does not compile.</exception>
        internal byte[] Compile() => ShaderCompiler.Compile(Files, Name, Source, Stage, Entry, Keywords);

        public override string ToString() => string.Join(" ", new[] { Name, Entry }.Concat(Keywords));
    }
}
