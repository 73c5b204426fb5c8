namespace StandIns.Graphics
{
    /// <summary>A constant in a constant buffer, of 4-byte components.</summary>
    sealed class ShaderMember
    {
        internal readonly string Name;
        internal readonly int NameId;
        internal readonly int Offset;
        /// <summary>Not whole numbers.</summary>
        internal readonly bool IsFloat;
        internal readonly int Columns;
        internal readonly int Rows;
        /// <summary>Elements of an array, <see cref="Stride"/> bytes apart; 1 where it is none.</summary>
        internal readonly int Count;
        internal readonly int Stride;

        internal ShaderMember(string name, int offset, bool isFloat, int columns, int rows, int count, int stride)
        {
            Name = name;
            NameId = PropertyNames.IdOf(name);
            Offset = offset;
            IsFloat = isFloat;
            Columns = columns;
            Rows = rows;
            Count = count;
            Stride = stride;
        }

        internal int End => Offset + (Count - 1) * Stride + (Columns > 1 ? Columns * 16 : Rows * 4);
    }
}
