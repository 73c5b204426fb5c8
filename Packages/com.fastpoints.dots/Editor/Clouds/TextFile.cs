using System;
using System.IO;
using System.Text;
using FastPoints.Base;
using FastPoints.Files;

namespace FastPoints.Editor
{
    /// <summary>Small text files that are whole or not there, whatever happens while they are written.</summary>
    static class TextFile
    {
        const string TemporarySuffix = ".tmp";

        /// <summary>Writes a file in place of the one of that name.</summary>
        /// <exception cref="PointCloudException">It cannot be written, or the disk is full; the old one is as it was.</exception>
        public static void Write(string path, string text)
        {
            // Unity does not import files of that extension.
            string temporary = path + TemporarySuffix;
            try
            {
                using (var file = new FileStream(temporary, FileMode.Create, FileAccess.Write, FileShare.None))
                {
                    byte[] bytes = new UTF8Encoding(false).GetBytes(text);
                    file.Write(bytes, 0, bytes.Length);
                    file.Flush(true);
                }
                if (File.Exists(path))
                    File.Replace(temporary, path, null);
                else
                    File.Move(temporary, path);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }
    }
}
