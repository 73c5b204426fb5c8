namespace FastPoints.Cli.Sources;

public static class Hints
{
    /// <returns>A sentence that continues the failure's message; empty without a hint.</returns>
    public static string For(PointCloudException failure)
    {
        string path = failure.Path ?? "";
        if (SourcePath.IsRemote(path))
            return failure.Code == FailureCode.AccessDenied && S3Addresses.IsUnsigned ? "; no credentials of AWS were found" : "";
        if (path.Contains("://", StringComparison.Ordinal))
            return "; an address begins with https:// or http://: download the file, and name that";
        if (failure.Code == FailureCode.Truncated && failure.Message.EndsWith("(an empty file, a pipe or a device)",
            StringComparison.Ordinal))
            return "; a cloud is read in any order: what comes from a pipe is read as -";
        if (Directory.Exists(path) && FolderBelow(path) is { } below)
            return "; clouds lie in folders below it: name those, such as " + below;
        if (failure.Code != FailureCode.Unsupported)
            return "";
        if (failure.Message.Contains("a PNG picture", StringComparison.Ordinal))
            return "; a picture holds no points: name the cloud that it was made from";
        if (failure.Message.Contains("a converted cloud already", StringComparison.Ordinal))
            return "; info, verify, picture and fly take it";
        bool isText = failure.Message.Contains("got text \"", StringComparison.Ordinal)
            || failure.Message.Contains("columns of the text", StringComparison.Ordinal);
        return isText ? "; if its lines are points, say what the columns are: --columns x,y,z,... (- leaves one out, as words)"
            : "";
    }

    static string? FolderBelow(string path)
    {
        try
        {
            return Directory.EnumerateDirectories(path).FirstOrDefault(d => Directory.EnumerateFiles(d).Any(OutputNames.IsCloud));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }
}
