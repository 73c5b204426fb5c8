namespace FastPoints.Tests.Support
{
    /// <summary>An attribute that a test writes, of hashed bytes but for the position and the point's number.</summary>
    public sealed class PotreeTestAttribute
    {
        public readonly string Name;
        public readonly string Type;
        public readonly int Elements;
        public readonly int ElementBytes;

        public PotreeTestAttribute(string name, string type, int elements = 1)
        {
            Name = name;
            Type = type;
            Elements = elements;
            ElementBytes = type == "double" || type.EndsWith("64") ? 8 : type == "float" || type.EndsWith("32") ? 4
                : type.EndsWith("16") ? 2 : 1;
        }

        public int Bytes => Elements * ElementBytes;
    }
}
