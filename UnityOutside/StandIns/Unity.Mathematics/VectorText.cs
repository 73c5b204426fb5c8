namespace Unity.Mathematics;

internal static class VectorText
{
    /// <summary>Unity's form: "float3(1f, 2f, 3f)"; of a matrix the rows, with a wider gap between them.</summary>
    internal static string Of(string type, string suffix, string format, IFormatProvider provider, int columns,
        params IFormattable[] numbers)
    {
        var text = new StringBuilder(type).Append('(');
        for (int i = 0; i < numbers.Length; i++)
        {
            if (i > 0)
                text.Append(i % columns == 0 ? ",  " : ", ");
            text.Append(numbers[i].ToString(format, provider)).Append(suffix);
        }
        return text.Append(')').ToString();
    }
}
