using System;
using System.IO;
using FastPoints.Reading;
using Unity.Mathematics;

namespace FastPoints.Sources
{
    // r.bin and the others side by side (1.4), or r/r.bin with a folder for each page of the hierarchy below it (from 1.5 on):
    // r/01234/r01234.hrc.
    sealed class Potree1Files
    {
        static readonly string[] s_extensions = { ".bin", ".las", ".laz", ".hrc" };

        readonly string m_folder;
        readonly string m_extension;
        readonly int m_stepSize;
        readonly bool m_isFlat;

        Potree1Files(string folder, string extension, bool isFlat, int stepSize)
        {
            m_folder = folder;
            m_extension = extension;
            m_isFlat = isFlat;
            m_stepSize = stepSize;
        }

        // In the folder that cloud.js names, or else beside cloud.js or in a folder there, since clouds are moved and renamed.
        public static Potree1Files Find(Potree1Index index)
        {
            string home = SourcePath.FolderOf(SourcePath.Full(index.Info.Path)) ?? ".";
            string extension = index.NodeFormat == null ? ".bin" : index.NodeFormat == "LAS" ? ".las" : ".laz";
            bool isFlat = index.Hierarchy != null;
            foreach (string folder in new[] { Combine(home, index.OctreeFolder), Combine(home, "data"), home })
                if (TryAt(folder, out string at))
                    return new Potree1Files(at, extension, isFlat, index.StepSize);
            foreach (string folder in FoldersIn(home))
                if (TryAt(folder, out string at))
                {
                    index.Info.Warn(-1,
                        "the nodes are not in \"" + index.OctreeFolder + "\" but in \"" + Path.GetFileName(folder) + "\"");
                    return new Potree1Files(at, extension, isFlat, index.StepSize);
                }
            throw new PointCloudException(FailureCode.NotFound, index.Info.Path, -1, "the nodes are not there: wanted r"
                + extension + " or r.hrc in \"" + index.OctreeFolder + "\" or in a folder beside this file");
        }

        public string PathOf(int level, int3 cell) => PathOf(level, cell, m_extension);

        public string HierarchyPathOf(int level, int3 cell) => PathOf(level, cell, ".hrc");

        public string AnyNode()
        {
            string root = PathOf(0, default);
            if (SourcePath.IsRemote(root) || File.Exists(root))
                return root;
            try
            {
                foreach (string path in Directory.EnumerateFiles(m_folder, "r*" + m_extension))
                    return path;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(m_folder, e);
            }
            throw new PointCloudException(FailureCode.NotFound, root, -1, "no such file, and no other node beside it");
        }

        string PathOf(int level, int3 cell, string extension)
        {
            string name = PotreeNames.NameOf(level, cell);
            string folder = m_folder;
            for (int at = 0; !m_isFlat && at + m_stepSize <= level; at += m_stepSize)
                folder = SourcePath.Combine(folder, name.Substring(1 + at, m_stepSize));
            return SourcePath.Combine(folder, name + extension);
        }

        static bool TryAt(string folder, out string at)
        {
            foreach (string candidate in new[] { SourcePath.Combine(folder, "r"), folder })
                foreach (string extension in s_extensions)
                    if (RandomAccessFile.LengthOf(SourcePath.Combine(candidate, "r" + extension)) != RandomAccessFile.NoSuchFile)
                    {
                        at = candidate;
                        return true;
                    }
            at = null;
            return false;
        }

        // An octreeDir may be anything, even an address on the web, which is not a folder here.
        static string Combine(string home, string folder)
        {
            if (SourcePath.IsRemote(home))
                return SourcePath.Combine(home, folder);
            try
            {
                return Path.GetFullPath(Path.Combine(home, folder));
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return home;
            }
        }

        // A server does not list them.
        static string[] FoldersIn(string folder)
        {
            if (SourcePath.IsRemote(folder))
                return Array.Empty<string>();
            try
            {
                var folders = Directory.GetDirectories(folder);
                Array.Sort(folders, string.CompareOrdinal);
                return folders;
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.ReadFailure(folder, e);
            }
        }
    }

    struct Potree1Node
    {
        public int Level;
        public int3 Cell;
        public long Claimed;
        public string Path;
        public long Bytes; // -1 if there is no such file.

        public long PointsOfLas;
        public string Problem;
    }

    struct Potree1Page
    {
        public ByteReader Records;
        public long FileBytes;
        public PointCloudException Problem;
    }
}
