using System;
using System.IO;
using System.Text;
using FastPoints.Reading;
using UnityEditor;
using UnityEngine;

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
                throw FileFailures.WriteFailure(path, e);
            }
        }
    }

    /// <summary>Files of the project that version control may lock until somebody checks them out.</summary>
    static class VersionedFile
    {
        /// <summary>Checks a file out, if it is there, so that it may be written, without asking. Main thread.</summary>
        /// <exception cref="PointCloudException">Version control refuses, or the file is read-only.</exception>
        public static void CheckOut(string path)
        {
            if (!File.Exists(path))
                return;
            string project = Path.GetDirectoryName(Application.dataPath);
            if (!AssetDatabase.MakeEditable(Path.GetRelativePath(project, path).Replace('\\', '/')))
                throw new PointCloudException(FailureCode.WriteFailed, path, -1, "version control does not check it out");
            // Linux and macOS would replace it all the same.
            if ((File.GetAttributes(path) & FileAttributes.ReadOnly) != 0)
                throw new PointCloudException(FailureCode.WriteFailed, path, -1,
                    "is read-only: check it out, or make it writable");
        }
    }
}
