namespace StandIns.Graphics;

sealed class ShaderResource(uint variable, string name, DescriptorType kind)
{
    internal readonly string Name = name;
    internal readonly int NameId = PropertyNames.IdOf(name);
    internal readonly DescriptorType Kind = kind;
    internal readonly uint Variable = variable;
    internal ShaderMember[] Members { get; set; } = System.Array.Empty<ShaderMember>();
    internal int Stride { get; set; }
    internal bool IsWritten { get; set; }
    internal bool IsArray { get; set; }

    internal Format Format { get; set; } // Of a texture that is read and written at random; undefined where it may have any.

    internal int Binding { get; set; }

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
