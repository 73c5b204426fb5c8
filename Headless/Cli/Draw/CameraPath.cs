namespace FastPoints.Cli.Draw;

public sealed class CameraPath
{
    readonly record struct Keyframe(int Frame, double3 Eye, double3 Target, bool IsCut);

    readonly List<Keyframe> m_keys = [];
    readonly double3 m_up;
    readonly double m_fovDegrees;

    CameraPath(double3 up, double fovDegrees) => (m_up, m_fovDegrees) = (up, fovDegrees);

    public int FrameCount => m_keys[^1].Frame + 1;

    public bool IsCut(int frame) => m_keys.Exists(k => k.IsCut && k.Frame == frame);

    public static CameraPath Read(string path, double3 up, double fovDegrees)
    {
        var result = new CameraPath(up, fovDegrees);
        string[] lines;
        try
        {
            lines = File.ReadAllLines(path);
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new PointCloudException(FailureCode.NotFound, path, -1, "no such file", e);
        }
        for (int i = 0; i < lines.Length; i++)
        {
            var words = lines[i].Split('#')[0].Split([' ', '\t', ','], StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0)
                continue;
            var numbers = new double[7];
            bool isValid = words.Length == 7 || (words.Length == 8 && words[7] == "cut");
            for (int w = 0; isValid && w < 7; w++)
                isValid = double.TryParse(words[w], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[w])
                    && double.IsFinite(numbers[w]);
            if (!isValid || numbers[0] != Math.Floor(numbers[0]) || numbers[0] > 10_000_000
                || numbers[0] <= (result.m_keys.Count == 0 ? -1 : result.m_keys[^1].Frame))
                throw new PointCloudException(FailureCode.BadInput, path, -1, "line " + (i + 1)
                    + ": wanted a frame after the one before, an eye, a target, and perhaps \"cut\"");
            result.m_keys.Add(new Keyframe((int)numbers[0], new double3(numbers[1], numbers[2], numbers[3]),
                new double3(numbers[4], numbers[5], numbers[6]), words.Length == 8));
        }
        if (result.m_keys.Count == 0)
            throw new PointCloudException(FailureCode.BadInput, path, -1, "no line with a frame, an eye and a target");
        return result;
    }

    public static CameraPath Tour(BoundsGeo bounds, UpAxis upAxis, int frames, double fovDegrees)
    {
        upAxis.Directions(out var east, out var north, out var up);
        var path = new CameraPath(up, fovDegrees);
        var size = bounds.Size;
        double width = math.dot(math.abs(east), size), depth = math.dot(math.abs(north), size);
        double reach = math.max(math.max(width, depth), 1e-6 + math.dot(math.abs(up), size));
        var ground = bounds.Center;
        double3 At(double x, double y, double z) => ground + east * (x * width) + north * (y * depth) + up * (z * reach);
        void Add(double share, double3 eye, double3 target, bool isCut = false) =>
            path.m_keys.Add(new Keyframe((int)(share * (frames - 1)), eye, target, isCut));
        Add(0, At(-0.3, -0.9, 0.7), ground);
        Add(0.2, At(0.3, -0.8, 0.5), ground);
        Add(0.4, At(0.25, -0.25, 0.09), At(0.05, 0.1, 0));
        Add(0.62, At(-0.2, 0.1, 0.08), At(-0.3, 0.45, 0));
        Add(0.64, At(0.42, 0.42, 0.06), At(0.1, 0.2, -0.02), true);
        Add(0.85, At(0.3, 0.3, 0.06), At(0, 0.1, -0.02));
        Add(1, At(0.3, 0.3, 0.06), At(0, 0.1, -0.02));
        // Few frames: several keys fall on one.
        for (int i = path.m_keys.Count - 2; i >= 0; i--)
            if (path.m_keys[i].Frame == path.m_keys[i + 1].Frame)
                path.m_keys.RemoveAt(i);
        return path;
    }

    public Camera CameraAt(int frame)
    {
        int next = m_keys.FindIndex(k => k.Frame > frame);
        int last = next < 0 ? m_keys.Count - 1 : Math.Max(0, next - 1);
        var key = m_keys[last];
        if (next <= 0 || m_keys[next].IsCut)
            return Camera.Perspective(key.Eye, key.Target, m_up, m_fovDegrees);
        double along = (frame - key.Frame) / (double)(m_keys[next].Frame - key.Frame);
        return Camera.Perspective(Interpolate(last, along, k => k.Eye), Interpolate(last, along, k => k.Target), m_up,
            m_fovDegrees);
    }

    double3 Interpolate(int key, double t, Func<Keyframe, double3> of)
    {
        double3 b = of(m_keys[key]), c = of(m_keys[key + 1]);
        var a = key == 0 || m_keys[key].IsCut ? b : of(m_keys[key - 1]);
        var d = key + 2 >= m_keys.Count || m_keys[key + 2].IsCut ? c : of(m_keys[key + 2]);
        return 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * (t * t) + (3 * b - a - 3 * c + d) * (t * t * t));
    }
}
