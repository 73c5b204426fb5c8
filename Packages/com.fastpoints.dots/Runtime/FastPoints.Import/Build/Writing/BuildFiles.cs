using System.Globalization;

namespace FastPoints.Build
{
    /// <summary>Names of files that exist only in a folder in the making.</summary>
    internal static class BuildFiles
    {
        /// <summary>The journal of the build, from which a killed one is continued.</summary>
        public const string JournalName = "build.json";

        /// <summary>The folder of points that are not in their nodes yet, as plain records.</summary>
        public const string RecordFolderName = "records";

        /// <summary>Chunks' top nodes, which the merge of the upper levels consumes.</summary>
        public const string TopFolderName = "tops";

        public static string RecordPath(int number) => PathOf(RecordFolderName, number);

        public static string TopPath(int number) => PathOf(TopFolderName, number);

        static string PathOf(string folder, int number) =>
            folder + "/" + number.ToString("D6", CultureInfo.InvariantCulture) + ".bin";
    }
}
