namespace Unity.IO.LowLevel.Unsafe
{
    public static unsafe partial class AsyncReadManager
    {
        /// <summary>Content that is delivered from elsewhere asks for it: nothing here does.</summary>
        public static ReadHandle GetFileInfo(string filename, FileInfoResult* result) => throw new NotSupportedException();
    }

    public enum FileState { Absent = 0, Exists = 1 }

    public struct FileInfoResult
    {
        public long FileSize;
        public FileState FileState;
    }
}
