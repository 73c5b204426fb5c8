using System;
using FastPoints.Reading;
using FastPoints.Sources;

namespace FastPoints.Tests.Sources
{
    sealed class TreeTestCloud : IDisposable
    {
        public const string Copc = "COPC", EptBinary = "EPT bin", EptLaz = "EPT laz", EptZstandard = "EPT zst",
            Potree1 = "Potree 1", Potree2 = "Potree 2", Potree2Brotli = "Potree 2 brotli";

        public static readonly string[] Kinds = { Copc, EptBinary, EptLaz, EptZstandard, Potree1, Potree2, Potree2Brotli };

        readonly IDisposable m_files;

        public TreeTestCloud(string kind, int points = 3000)
        {
            switch (kind)
            {
                case Copc:
                    var writer = new CopcFileWriter { LevelsPerPage = 1, MaxNodePoints = 60 };
                    var file = new TemporaryFile(writer.Write(LazRecords.Make(7, 0, points, 7)), ".copc.laz");
                    m_files = file;
                    Path = file.Path;
                    break;
                case EptBinary:
                case EptLaz:
                case EptZstandard:
                    var type = kind == EptBinary ? EptDataType.Binary
                        : kind == EptLaz ? EptDataType.Laszip : EptDataType.Zstandard;
                    var ept = EptTestClouds.Make(type, points, 2, 3, 60);
                    m_files = ept;
                    Path = ept.Path;
                    Decompressors.Zstandard = () => new StoredZstandard();
                    break;
                default:
                    var folder = new TemporaryFolder();
                    m_files = folder;
                    Path = folder.Path;
                    var cloud = new PotreeTestCloud(points, 7, 11);
                    if (kind == Potree1)
                        new Potree1Writer().Write(folder, cloud);
                    else
                        new Potree2Writer { IsBrotli = kind == Potree2Brotli }.Write(folder, cloud);
                    break;
            }
        }

        public string Path { get; }

        public TreeSource Open(params string[] planes) => Open(Path, planes);

        public static TreeSource Open(string path, params string[] planes)
        {
            var reader = PointReaders.Open(path);
            JobCoroutine.RunToEnd(TreeSource.ReadTop(reader));
            return new TreeSource(reader, planes);
        }

        public void Dispose()
        {
            Decompressors.Zstandard = null;
            m_files.Dispose();
        }
    }
}
