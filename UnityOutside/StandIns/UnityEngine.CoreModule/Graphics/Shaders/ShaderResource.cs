namespace StandIns.Graphics;

/// <summary>Something that a shader names and a draw or dispatch has to bring: a buffer, a texture, a sampler,
/// constants.</summary>
sealed class ShaderResource(uint variable, string name, VkDescriptorType kind)
{
    internal readonly string Name = name;
    internal readonly int NameId = PropertyNames.IdOf(name);
    internal readonly VkDescriptorType Kind = kind;
    /// <summary>Its id in the module that it was read from.</summary>
    internal readonly uint Variable = variable;

    /// <summary>Of constants: what is in them.</summary>
    internal ShaderMember[] Members { get; set; } = System.Array.Empty<ShaderMember>();

    /// <summary>Bytes from one element of a structured buffer to the next.</summary>
    internal int Stride { get; set; }

    /// <summary>A buffer that the shader may write.</summary>
    internal bool IsWritten { get; set; }

    /// <summary>A texture of slices.</summary>
    internal bool IsArray { get; set; }

    /// <summary>Of a texture that is read and written at random; undefined where it may have any.</summary>
    internal VkFormat Format { get; set; }

    internal int Binding { get; set; }

    /// <summary>Of constants, in bytes.</summary>
    internal int Size
    {
        get
        {
            int size = 0;
            foreach (ShaderMember member in Members)
                size = System.Math.Max(size, member.End);
            return (size + 15) / 16 * 16;
        }
    }
}
