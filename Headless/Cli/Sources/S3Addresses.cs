using Amazon.Runtime;
using Amazon.S3;
using Amazon.S3.Model;

namespace FastPoints.Cli.Sources;

/// <summary>s3://bucket/key, read by its address on the web with a signature that the AWS SDK makes. Region, endpoint and
/// credentials are where the SDK finds them: AWS_REGION, AWS_ENDPOINT_URL_S3, AWS_ACCESS_KEY_ID, profiles, roles.</summary>
sealed class S3Addresses
{
    const string Scheme = "s3://";

    readonly Dictionary<string, string> m_bucketOfAddress = [];
    readonly AmazonS3Client m_client;

    /// <summary>Shapes addresses as the other one does, and needs no credentials.</summary>
    readonly AmazonS3Client m_shaping;

    S3Addresses()
    {
        var config = new AmazonS3Config();
        if (config.RegionEndpoint == null && config.ServiceURL == null)
            throw new UsageException("s3:// needs the bucket's region: AWS_REGION, or a profile");
        m_client = new AmazonS3Client(config);
        m_shaping = new AmazonS3Client(new BasicAWSCredentials("none", "none"), config);
    }

    internal static TimeSpan Lifetime { get; set; } = TimeSpan.FromHours(1);

    /// <summary>No credentials were found: what is public is read all the same.</summary>
    public static bool IsUnsigned { get; private set; }

    /// <returns>The words, with addresses in place of those that begin with s3://; from now on these are signed.</returns>
    public static IReadOnlyList<string> Resolve(IReadOnlyList<string> words)
    {
        if (!words.Any(IsS3))
            return words;
        var addresses = new S3Addresses();
        words = [.. words.Select(word => IsS3(word) ? addresses.AddressOf(word) : word)];
        IsUnsigned = !addresses.HasCredentials();
        RemoteAccess.Sign = IsUnsigned ? null : (address, _) => addresses.Sign(address);
        return words;
    }

    static bool IsS3(string word) => word.StartsWith(Scheme, StringComparison.OrdinalIgnoreCase);

    string AddressOf(string word)
    {
        string[] parts = word[Scheme.Length..].Split('/', 2);
        if (parts.Length < 2 || parts[0].Length == 0 || parts[1].Length == 0)
            throw new UsageException(word + ": wanted s3://bucket/key");
        m_bucketOfAddress[SourcePath.WithoutQuery(Signed(m_shaping, parts[0], "k"))[..^1]] = parts[0];
        return SourcePath.WithoutQuery(Signed(m_shaping, parts[0], parts[1]));
    }

    bool HasCredentials()
    {
        try
        {
            Signed(m_client, m_bucketOfAddress.Values.First(), "k");
            return true;
        }
        catch (Exception e) when (e is AmazonClientException or AmazonServiceException)
        {
            return false;
        }
    }

    Uri? Sign(Uri address)
    {
        foreach ((string start, string bucket) in m_bucketOfAddress)
            if (address.AbsoluteUri.StartsWith(start, StringComparison.Ordinal))
                return new Uri(Signed(m_client, bucket, Uri.UnescapeDataString(address.AbsoluteUri[start.Length..])));
        return null;
    }

    static string Signed(AmazonS3Client client, string bucket, string key) => client.GetPreSignedURL(new GetPreSignedUrlRequest
    {
        BucketName = bucket,
        Key = key,
        Expires = DateTime.UtcNow + Lifetime,
        Protocol = client.Config.ServiceURL?.StartsWith("http:", StringComparison.Ordinal) == true
            ? Protocol.HTTP : Protocol.HTTPS,
    });
}
