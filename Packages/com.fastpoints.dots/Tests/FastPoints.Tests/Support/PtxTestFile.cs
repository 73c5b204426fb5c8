using System.Globalization;
using System.Text;

namespace FastPoints.Tests
{
    /// <summary>Scans in PTX: each third place has no return. The matrix turns by 90 degrees about z and shifts.</summary>
    static class PtxTestFile
    {
        public static string Scan(int columns, int rows, int shift = 1000)
        {
            var text = new StringBuilder();
            text.Append(columns + "\n" + rows + "\n1 2 3\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n");
            text.Append(shift + " 20 3 1\n");
            for (int i = 0; i < columns * rows; i++)
                text.Append(i % 3 == 2 ? "0 0 0 0.5 0 0 0\n" : string.Format(CultureInfo.InvariantCulture,
                    "{0}.25 -{1} 0.5 0.75 {2} 7 300\n", i, i + 1, i % 256));
            return text.ToString();
        }
    }
}
