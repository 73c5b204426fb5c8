namespace Unity.Mathematics;

public struct bool2 : IEquatable<bool2>
{
    [MarshalAs(UnmanagedType.U1)] public bool x;
    [MarshalAs(UnmanagedType.U1)] public bool y;

    [MethodImpl(Inline)] public bool2(bool x, bool y) => (this.x, this.y) = (x, y);

    [MethodImpl(Inline)] public bool Equals(bool2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is bool2 converted && Equals(converted);
    public override int GetHashCode() => (int)((x ? 0xFAAF07DDu : 0x90A285BBu) + (y ? 0x625C45BDu : 0x5D19E1D5u));
    public override string ToString() => $"bool2({x}, {y})";
}
