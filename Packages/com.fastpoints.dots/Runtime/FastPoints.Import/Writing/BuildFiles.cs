using System.Globalization;

namespace FastPoints.Writing
{
    /// <summary>Names in a folder in the making, of what is gone when the cloud is whole.</summary>
    internal static class BuildFiles
    {
        /// <summary>How far the build is: what a killed one is continued from.</summary>
        public const string JournalName = "build.json";

        /// <summary>Points on their way into chunks: plain records.</summary>
        public const string RecordFolderName = "records";

        /// <summary>Chunks' top nodes, which the merge of the upper levels consumes.</summary>
        public const string TopFolderName = "tops";

        public static string RecordPath(int number) => PathOf(RecordFolderName, number);

        public static string TopPath(int number) => PathOf(TopFolderName, number);

        static string PathOf(string folder, int number) =>
            folder + "/" + number.ToString("D6", CultureInfo.InvariantCulture) + ".bin";
    }
}
