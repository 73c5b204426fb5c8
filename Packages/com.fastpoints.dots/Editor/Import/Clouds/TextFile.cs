using System;
using System.IO;
using System.Text;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Editor
{
    /// <summary>Writes small text files that are always complete or absent, whatever happens during writing.</summary>
    static class TextFile
    {
        const string TemporarySuffix = ".tmp";

        /// <summary>Replaces the file of that name.</summary>
        /// <exception cref="PointCloudException">It cannot be written, or the disk is full; the old file is
        /// unchanged.</exception>
        public static void Write(string path, string text, bool flushes = true)
        {
            // Unity does not import files of that extension.
            string temporary = path + TemporarySuffix;
            try
            {
                using (var file = FileChanges.OpenToWrite(temporary, FileMode.Create))
                {
                    byte[] bytes = new UTF8Encoding(false).GetBytes(text);
                    file.Write(bytes, 0, bytes.Length);
                    file.Flush(flushes);
                }
                FileChanges.Replace(temporary, path);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }
    }
}
