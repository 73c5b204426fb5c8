namespace UnityOutside.Images;

/// <summary>PNG's row filters (PNG 3rd edition, section 9), which store bytes as differences from earlier ones.</summary>
static class PngFilters
{
    public const int None = 0;
    public const int Sub = 1;
    public const int Up = 2;
    public const int Average = 3;
    public const int Paeth = 4;

    /// <summary>Writes the filter byte and a row behind it, using the one of none, Sub and Up with the least sum of
    /// differences (section 12.7's rule of thumb).</summary>
    public static void Encode(byte[] pixels, int row, int rowBytes, int pixelBytes, byte[] to, int at)
    {
        int start = row * rowBytes;
        long none = 0, sub = 0, up = 0;
        for (int i = 0; i < rowBytes; i++)
        {
            byte value = pixels[start + i];
            byte left = i >= pixelBytes ? pixels[start + i - pixelBytes] : (byte)0;
            byte above = row > 0 ? pixels[start + i - rowBytes] : (byte)0;
            none += Math.Abs((int)(sbyte)value);
            sub += Math.Abs((int)(sbyte)(value - left));
            up += Math.Abs((int)(sbyte)(value - above));
        }
        int filter = none <= sub && none <= up ? None : sub <= up ? Sub : Up;
        to[at++] = (byte)filter;
        for (int i = 0; i < rowBytes; i++)
        {
            int before = filter == Sub && i >= pixelBytes ? pixels[start + i - pixelBytes]
                : filter == Up && row > 0 ? pixels[start + i - rowBytes] : 0;
            to[at++] = (byte)(pixels[start + i] - before);
        }
    }

    /// <summary>Undoes a row's filter in place.</summary>
    /// <param name="rows">Rows, each with its filter byte first; the rows above are decoded.</param>
    /// <returns>Whether the filter exists.</returns>
    public static bool Decode(byte[] rows, int row, int rowBytes, int pixelBytes)
    {
        int start = row * (rowBytes + 1) + 1;
        int filter = rows[start - 1];
        if (filter > Paeth)
            return false;
        for (int i = 0; i < rowBytes; i++)
        {
            int left = i >= pixelBytes ? rows[start + i - pixelBytes] : 0;
            int above = row > 0 ? rows[start + i - rowBytes - 1] : 0;
            int aboveLeft = row > 0 && i >= pixelBytes ? rows[start + i - rowBytes - 1 - pixelBytes] : 0;
            int before;
            switch (filter)
            {
                case Sub:
                    before = left;
                    break;
                case Up:
                    before = above;
                    break;
                case Average:
                    before = (left + above) / 2;
                    break;
                case Paeth:
                    before = PaethOf(left, above, aboveLeft);
                    break;
                default:
                    return true;
            }
            rows[start + i] = (byte)(rows[start + i] + before);
        }
        return true;
    }

    static int PaethOf(int left, int above, int aboveLeft)
    {
        int estimate = left + above - aboveLeft;
        int toLeft = Math.Abs(estimate - left);
        int toAbove = Math.Abs(estimate - above);
        int toAboveLeft = Math.Abs(estimate - aboveLeft);
        return toLeft <= toAbove && toLeft <= toAboveLeft ? left : toAbove <= toAboveLeft ? above : aboveLeft;
    }
}
