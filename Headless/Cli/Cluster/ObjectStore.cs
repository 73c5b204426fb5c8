using System.Runtime.ExceptionServices;
using System.Threading.Tasks;

namespace FastPoints.Cli.Cluster;

/// <summary>Where tasks put what they make, and find what others made: a folder that all of them see, or a bucket of S3's
/// interface. Objects have names with slashes; each is there as a whole, or not at all. Any thread.</summary>
abstract class ObjectStore : IDisposable
{
    public const string WorkFolder = "work/";

    protected ObjectStore(string name) => Name = name;

    public string Name { get; } // As in the plan, for messages.

    public abstract int Lanes { get; }

    public static ObjectStore Open(string name) => S3Addresses.IsS3(name) ? new S3Store(name) : new FolderStore(name);

    /// <summary>Puts a file, in place of one that may be there.</summary>
    public abstract void Put(string name, string path);

    public abstract string? ReadText(string name);

    public abstract void CopyRangeTo(string name, long offset, long count, Stream to);

    /// <summary>A file with an object's bytes: that of the store itself, or a copy.</summary>
    /// <param name="folder">For copies.</param>
    public abstract string EnsureLocal(string name, string folder);

    public abstract IEnumerable<(string Name, long Bytes)> List(string prefix);

    public abstract void Delete(IEnumerable<string> names);

    public abstract string CloudPath { get; } // Where the cloud is read when it is complete.

    /// <summary>Folders that a cloud has, if there is anything in them or not.</summary>
    public virtual void MakeFolders(params ReadOnlySpan<string> names) { }

    public virtual void Dispose() { }

    public void PutText(string name, string text, string scratchFolder)
    {
        string path = Path.Combine(scratchFolder, name.Replace('/', '-'));
        OutputFile.Write(path, Encoding.UTF8.GetBytes(text));
        Put(name, path);
    }

    public void ForEach<T>(IEnumerable<T> items, Action<T> work)
    {
        try
        {
            Parallel.ForEach(items, new ParallelOptions { MaxDegreeOfParallelism = Lanes }, work);
        }
        catch (AggregateException e)
        {
            ExceptionDispatchInfo.Throw(e.Flatten().InnerExceptions[0]);
        }
    }

    protected PointCloudException Failure(FailureCode code, string name, string what, Exception? inner = null) =>
        new(code, Name.TrimEnd('/') + "/" + name, -1, what, inner);
}
