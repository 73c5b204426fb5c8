namespace FastPoints.Cli.Verbs;

public sealed class CacheVerb : Verb
{
    readonly Flag m_clear = new("--clear", "Delete what is in it.");

    public CacheVerb() : base(new Command("cache", "Say what this user's cache of remote clouds holds, or clear it."))
    {
        Command.Add(m_clear);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints cache", "where it is, and how large"),
        ("./fastpoints cache --clear", "and from then on all is fetched again"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        run.Begin([]);
        var cache = RangeCache.Current;
        if (parsed.GetValue(m_clear))
            cache.Clear();
        run.WriteKeys = json =>
        {
            json.WriteInteger("entries", cache.Count);
            json.WriteInteger("bytes", cache.Bytes);
            json.WriteInteger("limitBytes", RemoteAccess.CacheBytes);
        };
        run.Out.WriteLine(cache.Folder + ": " + NumberFormat.Count(cache.Count, "range") + ", " + NumberFormat.Bytes(cache.Bytes)
            + " of " + NumberFormat.Bytes(RemoteAccess.CacheBytes));
    }
}
