using System.IO;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEditor.UnityLinker;

namespace FastPoints.Editor
{
    /// <summary>Has code stripping keep the readers of point cloud files where a player has clouds that are not converted:
    /// nothing else in it refers to them.</summary>
    public sealed class PlayerReaders : IUnityLinkerProcessor
    {
        const string Kept = "<linker>\n" +
            "  <assembly fullname=\"FastPoints.Import\">\n" +
            "    <type fullname=\"FastPoints.SourceFeeds.PointFileReaders\" preserve=\"all\" />\n" +
            "  </assembly>\n" +
            "</linker>\n";

        /// <summary>Whether the player that is built needs them.</summary>
        internal static bool s_areNeeded;

        public int callbackOrder => 0;

        /// <returns>The file's whole path; null for none.</returns>
        public string GenerateAdditionalLinkXmlFile(BuildReport report, UnityLinkerBuildPipelineData data)
        {
            if (!s_areNeeded)
                return null;
            string path = PointCloudImports.Paths.Absolute("Library/FastPoints/link.xml");
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, Kept);
            return path;
        }
    }
}
