using FastPoints.RepoTools.Behaviour;
using FastPoints.RepoTools.Epsg;
using FastPoints.RepoTools.Formats;
using FastPoints.RepoTools.Hlsl;
using FastPoints.RepoTools.House;
using FastPoints.RepoTools.Meta;
using FastPoints.RepoTools.Package;
using FastPoints.RepoTools.Threads;

namespace FastPoints.RepoTools;

public static class Program
{
    public static int Main(string[] args)
    {
        if (args.Length > 1 && args[0] == "guard")
            return Guard(args[1], args[2..]);
        string? verb = null;
        string? root = null;
        string? tag = null;
        string? list = null;
        string? database = null;
        bool check = false;
        bool flows = false;
        for (int i = 0; i < args.Length; i++)
        {
            switch (args[i])
            {
                case "--check":
                    check = true;
                    break;
                case "--flows":
                    flows = true;
                    break;
                case "--root" when i + 1 < args.Length:
                    root = args[++i];
                    break;
                case "--tag" when i + 1 < args.Length:
                    tag = args[++i];
                    break;
                case "--list" when i + 1 < args.Length:
                    list = args[++i];
                    break;
                case "-h":
                case "--help":
                    Console.Write(EmbeddedText.Of("usage.txt"));
                    return 0;
                default:
                    if (verb == "epsg" && database == null)
                    {
                        database = args[i];
                        break;
                    }
                    if (verb != null || args[i].StartsWith('-'))
                        return Misused($"not understood: {args[i]}");
                    verb = args[i];
                    break;
            }
        }
        if (verb == null)
            return Misused("no verb");
        try
        {
            Repository repository = root == null ? Repository.Find() : new Repository(root);
            if (verb == "epsg" && database != null)
                return Report(verb, EpsgCommand.Run(repository, database));
            return Report(verb, flows && verb == "house" ? HouseCommand.RunFlows(repository, check, list)
                : Run(verb, repository, check, tag, list));
        }
        catch (ToolException failure)
        {
            Console.Error.WriteLine(failure.Message);
            return 1;
        }
        catch (ArgumentException wrong) when (wrong.ParamName == nameof(verb))
        {
            return Misused($"no such verb: {verb}");
        }
        catch (IOException failure)
        {
            Console.Error.WriteLine(failure.Message);
            return 1;
        }
    }

    private static ToolResult Run(string verb, Repository repository, bool check, string? tag, string? list) => verb switch
    {
        "meta" => new MetaFiles(repository.PackageRoot).Run(check),
        "api" => ApiCommand.Run(repository, check),
        "threads" => ThreadCommand.Run(repository, check),
        "hlsl" => HlslCommand.Run(repository, check),
        "formats" => FormatCommand.Run(repository),
        "behaviour" => BehaviourCommand.Run(repository, check),
        "reference" => ReferenceCommand.Run(repository, check),
        "house" => HouseCommand.Run(repository, check, list),
        "package" => PackageCommand.Run(repository, tag, NpmPack.OfFolder(repository.PackageRoot)),
        _ => throw new ArgumentException("no such verb", nameof(verb)),
    };

    private static int Guard(string standIn, string[] references)
    {
        try
        {
            new MainThreadGuards(ThreadTable.Load(Repository.Find().UsedThreads)).Guard(standIn, references);
            return 0;
        }
        catch (IOException failure)
        {
            Console.Error.WriteLine(failure.Message);
            return 1;
        }
    }

    private static int Report(string verb, ToolResult result)
    {
        foreach (string problem in result.Problems)
            Console.Error.WriteLine(problem);
        Console.WriteLine($"{verb}: {result.Summary}" +
            (result.Problems.Count == 0 ? "" : $"; {result.Problems.Count} problems"));
        return result.Problems.Count == 0 ? 0 : 1;
    }

    private static int Misused(string reason)
    {
        Console.Error.WriteLine(reason);
        Console.Error.Write(EmbeddedText.Of("usage.txt"));
        return 2;
    }
}

public sealed record ToolResult(string Summary, IReadOnlyList<string> Problems);
