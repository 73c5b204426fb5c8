using System.IO;
using FastPoints.Core;
using UnityEditor;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>Files of the project that version control may lock until somebody checks them out.</summary>
    static class LockedFile
    {
        /// <summary>Checks a file out, if it is there, so that it may be written. Asks nobody. Main thread.</summary>
        /// <exception cref="PointCloudException">Version control refuses, or the file is read-only.</exception>
        public static void Open(string path)
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
