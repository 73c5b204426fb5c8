using System.Security.Cryptography;
using Amazon.Runtime;
using Amazon.S3;
using Amazon.S3.Model;

namespace FastPoints.Cli.Cluster;

/// <summary>A bucket of S3's interface. Every put is checked by the server (MD5) and by its answer (ETag); what fails on the way
/// is tried again, and a put that was done already does no harm.</summary>
sealed class S3Store : ObjectStore
{
    const int Tries = 6;

    readonly AmazonS3Client m_client;
    readonly string m_bucket;
    readonly string m_prefix;

    public S3Store(string name) : base(name)
    {
        (m_bucket, m_prefix) = S3Addresses.Split(name);
        m_prefix = m_prefix.TrimEnd('/') + "/";
        var config = S3Addresses.NewConfig();
        // Our own tries wait longer, and see broken bodies as well.
        config.MaxErrorRetry = 2;
        config.RequestChecksumCalculation = RequestChecksumCalculation.WHEN_REQUIRED;
        config.ResponseChecksumValidation = ResponseChecksumValidation.WHEN_REQUIRED;
        m_client = new AmazonS3Client(config);
    }

    internal static int PieceBytes { get; set; } = 64 << 20; // Larger files are put in pieces.

    internal static TimeSpan IdleTime { get; set; } = TimeSpan.FromSeconds(60);

    internal static TimeSpan FirstPause { get; set; } = TimeSpan.FromSeconds(0.5);

    public override int Lanes => 8;
    public override string CloudPath => S3Addresses.Add(Name.TrimEnd('/'));

    public override void Put(string name, string path)
    {
        long bytes = StoreFile.SizeOf(path);
        if (bytes <= PieceBytes)
            Try(FailureCode.WriteFailed, name, () => PutWhole(name, File.ReadAllBytes(path)));
        else
            Try(FailureCode.WriteFailed, name, () => PutPieces(name, path, bytes));
    }

    void PutWhole(string name, byte[] content)
    {
        byte[] hash = MD5.HashData(content);
        using var body = new MemoryStream(content);
        var answer = m_client.PutObjectAsync(new PutObjectRequest
        {
            BucketName = m_bucket,
            Key = m_prefix + name,
            InputStream = body,
            MD5Digest = System.Convert.ToBase64String(hash),
            UseChunkEncoding = false,
        }).Result;
        CheckTag(name, hash, answer.ETag, answer.ServerSideEncryptionMethod);
    }

    void PutPieces(string name, string path, long bytes)
    {
        var upload = m_client.InitiateMultipartUploadAsync(m_bucket, m_prefix + name).Result;
        try
        {
            var tags = new List<PartETag>();
            using var file = File.OpenRead(path);
            for (long done = 0; done < bytes; done += PieceBytes)
            {
                var content = new byte[Math.Min(PieceBytes, bytes - done)];
                file.ReadExactly(content);
                int number = tags.Count + 1;
                Try(FailureCode.WriteFailed, name, () => tags.Add(new PartETag(number, PutPiece(name, upload.UploadId, number,
                    content))));
            }
            m_client.CompleteMultipartUploadAsync(new CompleteMultipartUploadRequest
            {
                BucketName = m_bucket,
                Key = m_prefix + name,
                UploadId = upload.UploadId,
                PartETags = tags,
            }).Wait();
        }
        catch (AggregateException)
        {
            Abort(name, upload.UploadId);
            throw;
        }
    }

    /// <summary>Pieces that nobody completes cost money.</summary>
    void Abort(string name, string upload)
    {
        try
        {
            m_client.AbortMultipartUploadAsync(m_bucket, m_prefix + name, upload).Wait();
        }
        catch (AggregateException)
        {
            // The failure before is the one to tell.
        }
    }

    string PutPiece(string name, string upload, int number, byte[] content)
    {
        byte[] hash = MD5.HashData(content);
        using var body = new MemoryStream(content);
        var answer = m_client.UploadPartAsync(new UploadPartRequest
        {
            BucketName = m_bucket,
            Key = m_prefix + name,
            UploadId = upload,
            PartNumber = number,
            InputStream = body,
            MD5Digest = System.Convert.ToBase64String(hash),
            UseChunkEncoding = false,
        }).Result;
        CheckTag(name, hash, answer.ETag, answer.ServerSideEncryptionMethod);
        return answer.ETag;
    }

    /// <summary>The tag of what was put in one piece is its MD5, unless the server encrypts with a key of the user's.</summary>
    static void CheckTag(string name, byte[] hash, string? tag, ServerSideEncryptionMethod? encryption)
    {
        string wanted = System.Convert.ToHexStringLower(hash);
        string got = tag?.Trim('"') ?? throw new IOException(name + ": the answer has no ETag");
        bool isHash = got.Length == wanted.Length && (encryption == null || encryption == ServerSideEncryptionMethod.None
            || encryption == ServerSideEncryptionMethod.AES256);
        if (isHash && got != wanted)
            throw new IOException(name + ": wanted ETag " + wanted + ", got " + got);
    }

    public override string? ReadText(string name)
    {
        using var bytes = new MemoryStream();
        return Get(name, null, bytes, isHashed: true) ? Encoding.UTF8.GetString(bytes.ToArray()) : null;
    }

    public override void CopyRangeTo(string name, long offset, long count, Stream to)
    {
        if (count > 0 && !Get(name, (offset, count), to, isHashed: false))
            throw Failure(FailureCode.NotFound, name, "no such object");
    }

    public override string EnsureLocal(string name, string folder)
    {
        string path = Path.Combine(folder, name.Replace('/', '-'));
        bool isThere = false;
        OutputFile.WithFileErrors(path, () =>
        {
            using var file = new FileStream(path, FileMode.Create, FileAccess.ReadWrite);
            isThere = Get(name, null, file, isHashed: true);
        });
        return isThere ? path : throw Failure(FailureCode.NotFound, name, "no such object");
    }

    /// <summary>Reads an object; what breaks off goes on where it was.</summary>
    /// <param name="isHashed">All of it, and what comes is what its tag says.</param>
    /// <returns>Whether there is one.</returns>
    bool Get(string name, (long Offset, long Count)? range, Stream to, bool isHashed)
    {
        bool isThere = true;
        long start = to.Position, done = 0;
        Try(FailureCode.ReadFailed, name, () =>
        {
            try
            {
                var request = new GetObjectRequest { BucketName = m_bucket, Key = m_prefix + name };
                if (range is { } r)
                    request.ByteRange = new ByteRange(r.Offset + done, r.Offset + r.Count - 1);
                else if (done > 0)
                    request.ByteRange = new ByteRange("bytes=" + done + "-");
                using var answer = m_client.GetObjectAsync(request).Result;
                long left = range is { } wanted ? wanted.Count - done : answer.ContentLength;
                Read(name, answer.ResponseStream, to, left, ref done);
                if (!isHashed)
                    return;
                to.Position = start;
                byte[] hash = MD5.HashData(to);
                (long whole, done) = (done, 0);
                to.Position = start;
                CheckTag(name, hash, answer.ETag, answer.ServerSideEncryptionMethod);
                to.Position = start + whole;
            }
            catch (AggregateException e)
                when (e.GetBaseException() is AmazonServiceException { StatusCode: HttpStatusCode.NotFound })
            {
                isThere = false;
            }
        });
        return isThere;
    }

    static void Read(string name, Stream from, Stream to, long left, ref long done)
    {
        var buffer = new byte[1 << 18];
        for (int got; left > 0; left -= got, done += got)
        {
            using var idle = new CancellationTokenSource(IdleTime);
            got = from.ReadAsync(buffer.AsMemory(0, (int)Math.Min(left, buffer.Length)), idle.Token).AsTask().Result;
            if (got == 0)
                throw new IOException(name + ": wanted " + left + " bytes more");
            to.Write(buffer, 0, got);
        }
    }

    public override IEnumerable<(string Name, long Bytes)> List(string prefix)
    {
        var request = new ListObjectsV2Request { BucketName = m_bucket, Prefix = m_prefix + prefix };
        var all = new List<(string, long)>();
        ListObjectsV2Response? page = null;
        do
        {
            request.ContinuationToken = page?.NextContinuationToken;
            Try(FailureCode.ReadFailed, prefix, () => page = m_client.ListObjectsV2Async(request).Result);
            foreach (var found in page!.S3Objects ?? [])
                all.Add((found.Key[m_prefix.Length..], found.Size ?? 0));
        }
        while (page.IsTruncated == true);
        return all;
    }

    public override void Delete(IEnumerable<string> names) => ForEach(names, name =>
        Try(FailureCode.WriteFailed, name, () => m_client.DeleteObjectAsync(m_bucket, m_prefix + name).Wait()));

    public override void Dispose() => m_client.Dispose();

    void Try(FailureCode code, string name, Action work)
    {
        for (int tries = 1; ; tries++)
        {
            try
            {
                work();
                return;
            }
            catch (Exception e) when (e is AggregateException or IOException or AmazonClientException)
            {
                var cause = e.GetBaseException();
                bool isRefused = cause is AmazonServiceException
                {
                    StatusCode: HttpStatusCode.Forbidden
                    or HttpStatusCode.Unauthorized
                };
                if (isRefused || tries == Tries)
                    throw Failure(isRefused ? FailureCode.AccessDenied : code, name, cause.Message, e);
                Thread.Sleep(FirstPause * (1 << (tries - 1)));
            }
        }
    }
}
