namespace FastPoints.Cli.Publish;

/// <summary>The end of a cloud that was made of another one.</summary>
static class FinishedFolder
{
    /// <summary>Coroutine: copies files of the other cloud, as far as it has them, writes cloud.json when the pages were found
    /// to be right, and gives the folder its name.</summary>
    public static IEnumerator<JobStep> Write(CloudFolderWriter to, CloudManifest manifest, string from, params string[] copied)
    {
        foreach (string name in copied)
            if (Path.Combine(from, name) is var path && File.Exists(path))
                using (var content = StoreFile.Read(path, 0, StoreFile.SizeOf(path), Allocator.Persistent))
                    yield return JobStep.Of(CloudFolderWriter.Await(to.Write(name, content)));
        using (var written = CloudFolder.Open(to.PathOf(""), manifest))
            foreach (var _ in written.LoadAll())
                yield return default;
        yield return JobStep.Of(to.WriteText(StoreFormat.ManifestName, manifest.ToJson()));
        yield return JobStep.Of(to.Complete());
    }
}
