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
    private const string Usage = """
        usage: RepoTools VERB [--check] [--root DIR] [--tag TAG] [--flows] [--list NAME]
               RepoTools epsg PROJ_DB
               RepoTools guard STAND-IN REFERENCE... (the build calls it)

          meta      a .meta beside every file and folder of the package that Unity imports; a guid that is there is kept
          api       Headless/Api/used.tsv: the Unity signatures that the package uses, from the IL of each generation's build
                    (dotnet build Headless/Generations.proj) and the full list in $FASTPOINTS_DATA/unity-api
                    with --check, stand-ins show no type or member that neither the package, the host nor any test names
          threads   Headless/Api/threads.tsv: on which threads the members of Unity that the package uses may be called, from
                    these builds and the full table beside that list
          hlsl      Shaders/Generated/*.hlsl from the structs marked [GenerateHlsl]
          formats   compares the byte tables in Documentation~/internals/disk-format.md with the structs marked [DiskFormat]
          behaviour compares Headless/Api/behaviour.tsv with the stand-ins and tests that it names; makes the manual's list
                    of what is unverified from it
          reference the reference at the end of Documentation~/api.md: the public types of the compiled package
          guard     makes members of a stand-in refuse other threads than the main one, as Headless/Api/threads.tsv says
          house     prints how large the repository's parts are and refuses what is beyond the limits in
                    Headless/Api/house.tsv and above the ceilings in $FASTPOINTS_DATA/design/ceilings.tsv (or the copy beside
                    house.tsv); lowers limits that are above their goals to what has been reached
                    with --flows, the same of the files and rooms that each flow of house.tsv reaches, from the builds that
                    api reads: all types that the type of its first function names, those that these name, and so on; a base
                    does not reach what derives from it, so formats count where house.tsv or code of the flow names them
          package   compares the package with what Unity's package validation suite and npm ask of one, and prints its size

          epsg      Reading/EpsgTable.g.cs: EPSG's coordinate systems and their units, from PROJ's database (Debian's
                    proj-data has it in /usr/share/proj/proj.db)

          --check   writes nothing; says what is not as it should be
          --root    the repository (default: the one that this program was built in)
          --tag     with package: the tag of a release, which is the version and has an entry with a date
          --list    with house: names all that a measure counts; with --flows, a flow's files by room

        Exit status: 0 all is well (or was written), 1 it is not, 2 usage.
        """;

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
                    Console.WriteLine(Usage);
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
        Console.Error.WriteLine(Usage);
        return 2;
    }
}

public sealed record ToolResult(string Summary, IReadOnlyList<string> Problems);
