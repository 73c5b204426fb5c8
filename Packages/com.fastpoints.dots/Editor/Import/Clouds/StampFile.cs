using System.IO;
using FastPoints.Core;
using FastPoints.Store;

namespace FastPoints.Editor
{
    /// <summary>Keeps the stamp of a source without a handle, a file in <c>Assets</c>, beside the converted cloud.</summary>
    internal static class StampFile
    {
        const string Extension = ".source.json";
        const int Version = 1;

        /// <param name="cloud">The converted folder.</param>
        public static string PathOf(string cloud) => Path.ChangeExtension(cloud, null) + Extension;

        /// <returns>Null if there is none.</returns>
        /// <exception cref="PointCloudException">It cannot be read, or is not a stamp.</exception>
        public static SourceStamp Read(string cloud)
        {
            string path = PathOf(cloud);
            if (!File.Exists(path))
                return null;
            var json = JsonMembers.Parse(StoreFile.ReadText(path), path);
            json.RequireVersion(Version);
            return SourceStamp.Read(json.ObjectOrNull("stamp") ?? throw json.Wrong("stamp", "missing"));
        }

        /// <exception cref="PointCloudException">It cannot be written.</exception>
        public static void Write(string cloud, SourceStamp stamp)
        {
            var json = new JsonWriter().BeginObject().Add("version", Version);
            stamp.Write(json, "stamp", true);
            TextFile.Write(PathOf(cloud), json.EndObject().ToString());
        }
    }
}
