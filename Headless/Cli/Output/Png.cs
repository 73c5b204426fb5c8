namespace FastPoints.Cli.Output;

static class Png
{
    public static byte[] Encode(RgbaImage image) => PngCodec.Encode(image.Rgba, image.Width, image.Height);

    public static RgbaImage Read(string path)
    {
        try
        {
            return Decode(File.ReadAllBytes(path), path);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            var code = failure is UnauthorizedAccessException ? FailureCode.AccessDenied
                : failure is FileNotFoundException or DirectoryNotFoundException ? FailureCode.NotFound : FailureCode.ReadFailed;
            throw new PointCloudException(code, path, -1, "the picture cannot be read: " + failure.Message, failure);
        }
    }

    public static RgbaImage Decode(byte[] file, string path)
    {
        try
        {
            byte[] rgba = PngCodec.Decode(file, out int width, out int height);
            var image = new RgbaImage(width, height);
            rgba.CopyTo(image.Rgba, 0);
            return image;
        }
        catch (PngException failure)
        {
            var code = failure.Failure switch
            {
                PngFailure.BadInput => FailureCode.BadInput,
                PngFailure.Truncated => FailureCode.Truncated,
                _ => FailureCode.Unsupported,
            };
            throw new PointCloudException(code, path, failure.ByteOffset, failure.Message, failure.InnerException);
        }
    }
}
