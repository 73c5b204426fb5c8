namespace FastPoints.Cli.Page;

sealed class DensityMap
{
    const int MaxCells = 256;
    const int PointsOfCell = 16; // Mean sample points of a cell; with fewer the density is noise.

    readonly RgbaImage m_image;

    /// <param name="lengths">Of a unit of each axis.</param>
    public DensityMap(ViewPoints sample, BoundsGeo bounds, double3 lengths, UpAxis upAxis, long points)
    {
        upAxis.Directions(out var east, out var north, out _);
        double3 size = bounds.Size * lengths;
        double width = math.dot(size, math.abs(east)), depth = math.dot(size, math.abs(north));
        HasArea = Math.Min(width, depth) > 1e-6 * math.cmax(size);
        (width, depth) = (Math.Max(width, 1e-9), Math.Max(depth, 1e-9));
        double wanted = Math.Sqrt(PointsOfCell * width * depth / Math.Max(1, sample.Count));
        CellSize = Math.Max(wanted, Math.Max(width, depth) / MaxCells);
        int columns = (int)(width / CellSize) + 1, rows = (int)(depth / CellSize) + 1;
        int[] counts = new int[columns * rows];
        for (int i = 0; i < sample.Count; i++)
        {
            double3 place = (sample[i] - bounds.Center) * lengths;
            double x = (math.dot(place, east) + width / 2) / CellSize, y = (math.dot(place, north) + depth / 2) / CellSize;
            if (x >= 0 && y >= 0 && x < columns && y < rows)
                counts[(rows - 1 - (int)y) * columns + (int)x]++;
        }
        double perCount = points / (double)Math.Max(1, sample.Count) / (CellSize * CellSize);
        double[] sorted = counts.Where(c => c > 0).Order().Select(c => c * perCount).ToArray();
        Quartiles = new[] { 1, 2, 3 }.Select(q => sorted.Length == 0 ? 0 : sorted[sorted.Length * q / 4]).ToArray();
        High = sorted.Length == 0 ? 1 : sorted[sorted.Length * 98 / 100];
        m_image = new RgbaImage(columns, rows);
        for (int i = 0; i < counts.Length; i++)
            if (counts[i] > 0)
                m_image[i % columns, i / columns] = Palettes.Viridis(Math.Min(1, counts[i] * perCount / High));
    }

    public bool HasArea { get; }
    public double CellSize { get; }

    public double[] Quartiles { get; } // Over the cells that have points, in points on a square unit of length.

    public double High { get; }

    public string ToHtml(string unit)
    {
        string colors = string.Join(',', Enumerable.Range(0, 6).Select(i => "#" + ViewColumn.Hex(Palettes.Viridis(i / 5.0))));
        string squared = "points/" + unit + "²";
        return "<h3>Density from above</h3><div class=\"map\"><img alt=\"Map of the density of points, seen from above\" "
            + $"src=\"data:image/png;base64,{System.Convert.ToBase64String(Png.Encode(m_image))}\"></div>"
            + $"<div class=\"scale\">0<b style=\"background:linear-gradient(90deg,{colors})\"></b>"
            + $"{NumberFormat.FourDigits(High)} {squared}</div>"
            + $"<figcaption>Squares of {NumberFormat.FourDigits(CellSize)} {unit}. Where there are points: a quarter of the "
            + $"squares below {NumberFormat.FourDigits(Quartiles[0])}, half below {NumberFormat.FourDigits(Quartiles[1])}, "
            + $"three quarters below {NumberFormat.FourDigits(Quartiles[2])} {squared}; from the sample, scaled up.</figcaption>";
    }
}
