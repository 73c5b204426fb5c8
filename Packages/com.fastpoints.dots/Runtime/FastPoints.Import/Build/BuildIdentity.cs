using System.IO;
using System.Text;
using FastPoints.Nodes;
using FastPoints.Store;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Decides whether a killed build had the same input as this one.</summary>
    internal static class BuildIdentity
    {
        /// <summary>Hashes everything that the stored bytes and the temporary files depend on.</summary>
        public static unsafe ulong Of(BuildContext build)
        {
            var plan = build.Plan;
            var map = build.Map;
            var settings = build.Settings;
            var text = new StringBuilder();
            foreach (var reader in build.Readers)
            {
                string path = reader.Info.Path;
                text.Append(Path.GetFullPath(path)).Append('|').Append(reader.Info.FileBytes).Append('|')
                    .Append(reader.PointCount)
                    .Append('|').Append(File.Exists(path) ? File.GetLastWriteTimeUtc(path).Ticks : 0).Append('\n');
            }
            foreach (var attribute in build.Attributes)
                text.Append(attribute).Append('\n');
            text.Append(plan.PointsPerChunk).Append('|').Append(plan.PointsPerPartition).Append('|').Append(plan.IsStored)
                .Append('|').Append(StoreFormat.Version).Append('|').Append(NodeSizes.Rules)
                .Append('|').Append(build.Records.StrideBytes).Append('|').Append(map.Chunks.Length).Append('|').Append(map.Cube)
                .Append('|').Append(settings.Sampler).Append('|').Append(settings.CellsLog2)
                .Append('|').Append(settings.MaxPointsPerLeaf);
            string all = text.ToString();
            fixed (char* first = all)
                return ContentHash.Of(first, all.Length * sizeof(char)) ^
                    ContentHash.Of(map.ChunkOfCell.GetUnsafeReadOnlyPtr(), map.ChunkOfCell.Length * sizeof(int));
        }
    }
}
