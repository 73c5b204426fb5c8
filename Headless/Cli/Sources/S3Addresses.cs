using Amazon.Runtime;
using Amazon.S3;
using Amazon.S3.Model;

namespace FastPoints.Cli.Sources;

/// <summary>s3://bucket/key, read by its address on the web with a signature that the AWS SDK makes. Region, endpoint and
/// credentials are where the SDK finds them: AWS_REGION, AWS_ENDPOINT_URL_S3, AWS_ACCESS_KEY_ID, profiles, roles.</summary>
sealed class S3Addresses
{
    const string Scheme = "s3://";
    public const string StoreOption = "--store"; // Its value is no source.

    readonly Dictionary<string, string> m_bucketOfAddress = [];
    readonly AmazonS3Client m_client;
    readonly AmazonS3Client m_shaping; // Shapes addresses as the other one does, and needs no credentials.

    static S3Addresses? s_current;

    S3Addresses()
    {
        var config = NewConfig();
        m_client = new AmazonS3Client(config);
        m_shaping = new AmazonS3Client(new BasicAWSCredentials("none", "none"), config);
    }

    internal static TimeSpan Lifetime { get; set; } = TimeSpan.FromHours(1);

    public static bool IsUnsigned { get; private set; } // No credentials were found: what is public is read all the same.

    /// <returns>The words, with addresses in place of those that begin with s3://; from now on these are signed. What is
    /// written to keeps its name.</returns>
    public static IReadOnlyList<string> Resolve(IReadOnlyList<string> words)
    {
        s_current = null;
        return [.. words.Select((word, i) => IsS3(word) && (i == 0 || words[i - 1] != StoreOption) ? Add(word) : word)];
    }

    /// <returns>The address of an object, or of what begins with it; from now on it is signed.</returns>
    public static string Add(string name)
    {
        var addresses = s_current ??= new S3Addresses();
        string address = addresses.AddressOf(name);
        IsUnsigned = !addresses.HasCredentials();
        RemoteAccess.Sign = IsUnsigned ? null : (signed, _) => addresses.Sign(signed);
        return address;
    }

    /// <summary>The reverse: what stands for an address in a file that others read.</summary>
    public static string NameOf(string address)
    {
        foreach ((string start, string bucket) in s_current?.m_bucketOfAddress ?? [])
            if (address.StartsWith(start, StringComparison.Ordinal))
                return Scheme + bucket + "/" + Uri.UnescapeDataString(address[start.Length..]);
        return address;
    }

    public static AmazonS3Config NewConfig()
    {
        var config = new AmazonS3Config();
        return config.RegionEndpoint != null || config.ServiceURL != null ? config
            : throw new UsageException("s3:// needs the bucket's region: AWS_REGION, or a profile");
    }

    public static (string Bucket, string Key) Split(string name)
    {
        string[] parts = name[Scheme.Length..].Split('/', 2);
        return parts.Length == 2 && parts[0].Length > 0 && parts[1].Length > 0 ? (parts[0], parts[1])
            : throw new UsageException(name + ": wanted s3://bucket/key");
    }

    public static bool IsS3(string word) => word.StartsWith(Scheme, StringComparison.OrdinalIgnoreCase);

    string AddressOf(string word)
    {
        var (bucket, key) = Split(word);
        m_bucketOfAddress[SourcePath.WithoutQuery(Signed(m_shaping, bucket, "k"))[..^1]] = bucket;
        return SourcePath.WithoutQuery(Signed(m_shaping, bucket, key));
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
