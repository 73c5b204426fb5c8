namespace StandIns.Graphics;

/// <summary>A constant in a constant buffer, of 4-byte components.</summary>
sealed class ShaderMember(string name, int offset)
{
    internal readonly string Name = name;
    internal readonly int NameId = PropertyNames.IdOf(name);
    internal readonly int Offset = offset;
    internal bool IsFloat;
    internal int Columns = 1;
    internal int Rows = 1;
    internal int Count = 1; // Elements of an array, Stride bytes apart; 1 if it is none.
    internal int Stride;

    internal int End => Offset + (Count - 1) * Stride + (Columns > 1 ? Columns * 16 : Rows * 4);
}
