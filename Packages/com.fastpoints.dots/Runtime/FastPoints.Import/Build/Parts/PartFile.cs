using System.Collections.Generic;


namespace FastPoints.Build
{
    /// <summary>The two files of a part: the tops that are merged with those of other parts, and the tables of its nodes.</summary>
    internal static class PartFile
    {
        public const string TopsName = "part.tops";
        public const string NodesName = "part.nodes";

        /// <summary>Coroutine: writes both, when the part's upper levels are collected.</summary>
        public static IEnumerator<JobStep> Write(CloudFolderWriter folder, BuildPart part, UpperMerge merge, PartResult result)
        {
            yield break;
        }

        /// <summary>Reads what part.nodes has of the part's points.</summary>
        public static PartResult ReadResult(string nodesPath, ulong cloudId) => null;
    }
}
