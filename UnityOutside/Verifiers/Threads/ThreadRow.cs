namespace UnityOutside.Threads;

/// <summary>One line of the table of threads: on which threads a member of Unity may be called (main, any, unknown), why, and
/// what differs in later generations. The full table's README says what each column holds.</summary>
public sealed record ThreadRow(string Id, string Threads, string Reason, string Varied)
{
    public const string Header = "#id\tthreads\twhy\tvaried";
    private const string HandMark = "hand: "; // The full table has lines by hand of its own, without the blank.

    public bool IsByHand => Reason.StartsWith(HandMark, StringComparison.Ordinal);

    /// <summary>Whether it belongs on the main thread though the sources show no check: jobs' scheduling.</summary>
    public bool IsAskedForMain => Reason.Contains("the manual asks for the main thread", StringComparison.Ordinal);

    public static ThreadRow Parse(string line)
    {
        string[] c = line.Split('\t');
        string At(int i) => i < c.Length ? c[i] : "";
        return new ThreadRow(c[0], At(1), At(2), At(3));
    }

    public string Compose() => string.Join('\t', Id, Threads, Reason, Varied).TrimEnd('\t');

    /// <summary>On which threads that generation lets it be called.</summary>
    public string In(string generation, string accessor)
    {
        string threads = Threads;
        foreach (string[] change in Varied.Split(',').Select(v => v.Split('@')).Where(v => v.Length == 2))
        {
            if (string.CompareOrdinal(change[1], generation) <= 0)
                threads = change[0];
        }
        string other = "; " + accessor + ":";
        int at = Reason.LastIndexOf(other, StringComparison.Ordinal);
        return threads == Threads && at >= 0 ? Reason[(at + other.Length)..] : threads;
    }
}
