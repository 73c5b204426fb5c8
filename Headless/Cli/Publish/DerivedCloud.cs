namespace FastPoints.Cli.Publish;

/// <summary>Begin and end of a cloud that is made of another one.</summary>
static class DerivedCloud
{
    /// <summary>Coroutine: deletes what a killed run left, but no conversion that can go on.</summary>
    public static IEnumerator<JobStep> Begin(CloudFolderWriter to)
    {
        if (!to.HasLeftovers)
            yield break;
        if (File.Exists(to.PathOf(BuildFiles.JournalName)))
        {
            to.Keep();
            throw new PointCloudException(FailureCode.WriteFailed, to.PathOf(""), -1,
                "is a conversion that was stopped: let it go on, or delete the folder");
        }
        yield return JobStep.Of(to.Clear());
    }

    /// <summary>Coroutine: copies files of the other cloud, as far as it has them, writes cloud.json when the pages were found
    /// to be right, and gives the folder its name.</summary>
    public static IEnumerator<JobStep> End(CloudFolderWriter to, CloudManifest manifest, string from, params string[] copied)
    {
        foreach (string name in copied)
            if (Path.Combine(from, name) is var path && File.Exists(path))
                using (var content = StoreFile.Read(path, 0, StoreFile.SizeOf(path), Allocator.Persistent))
                    yield return JobStep.Of(CloudFolderWriter.Await(to.Write(name, content)));
        using (var written = CloudFolder.Open(to.PathOf(""), manifest))
            foreach (var _ in written.EachTable())
                yield return default;
        yield return JobStep.Of(to.WriteText(StoreFormat.ManifestName, manifest.ToJson()));
        yield return JobStep.Of(to.Complete());
    }
}
