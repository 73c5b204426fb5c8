namespace FastPoints.HostTests.Repository.PlantedApi;

/// <summary>Says <c>what</c> it is, of a
/// <see cref="Record"/> | more. And then says more.</summary>
public sealed class Opened : IDisposable
{
    public const int None = -1;

    public Opened(string path, long limitBytes = 3)
    {
        Path = path + limitBytes;
    }

    public string Path { get; }

    public static Opened Open(string path, DayOfWeek day = DayOfWeek.Friday) => new Opened(path, (long)day);

    public static Opened Open(string path) => new Opened(path);

    public void Dispose()
    {
    }

    public override string ToString() => Path;
}

public struct Record
{
    public const int SizeBytes = 4;
    public int X;
    public double[] Y;

    public static int Sum(in Record a, out List<int?> b, ref byte c, params string[] d)
    {
        b = new List<int?> { a.X, c, d.Length };
        return b.Count;
    }
}

public enum Many
{
    A,
    B,
    C,
    D,
    E,
    F,
    G,
}

public abstract class Generic<T>
{
    public abstract T[] Take<TOther>(Dictionary<TOther, Record> other, bool isWhole = true);

    internal abstract void Hide();
}
