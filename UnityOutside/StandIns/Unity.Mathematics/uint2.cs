namespace Unity.Mathematics;

public struct uint2 : IEquatable<uint2>, IFormattable
{
    public uint x, y;

    [MethodImpl(Inline)] public uint2(uint x, uint y) => (this.x, this.y) = (x, y);

    [MethodImpl(Inline)] public bool Equals(uint2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is uint2 converted && Equals(converted);
    public override int GetHashCode() => (int)(x * 0x4473BBB1u + y * 0xCBA11D5Fu + 0x685835CFu);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("uint2", "", format, formatProvider, 2, x, y);
}
