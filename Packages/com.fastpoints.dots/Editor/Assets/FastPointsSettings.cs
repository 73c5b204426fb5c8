using FastPoints.Convert;
using FastPoints.Entities;
using FastPoints.Samplers;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>What a project says of its imports: in <c>ProjectSettings/FastPoints.asset</c>, for version control.</summary>
    [FilePath("ProjectSettings/FastPoints.asset", FilePathAttribute.Location.ProjectFolder)]
    internal sealed class FastPointsSettings : ScriptableSingleton<FastPointsSettings>
    {
        public Sampler Sampler = Sampler.Random;

        /// <summary>Where converted clouds are: relative to the project, or a whole path. Those that are elsewhere stay there,
        /// and are
        /// found where their handles say.</summary>
        public string Place = ProjectPaths.DefaultClouds;

        /// <summary>For all of a conversion that grows with the number of points; what does not fit goes to files.</summary>
        public int MemoryMiB = 1024;

        /// <summary>Workers of the job system that a conversion keeps busy at most; 0 for all.</summary>
        public int Workers;

        /// <summary>Time of the main thread that an update of the editor gives to a conversion.</summary>
        public int UpdateMs = 4;

        /// <summary>Graphics memory of points in the editor, where a scene has no <see cref="PointCloudSettings"/>; new ones
        /// begin with it.</summary>
        public int GpuMiB = 512;

        /// <summary>Larger files are not copied into the project when they are dropped: they get a handle.</summary>
        public int CopiedMiB = 64;

        /// <summary>Whether what is imported is converted at once, or when somebody asks for it.</summary>
        public bool ConvertAtOnce = true;

        /// <summary>Whether that holds for COPC, Potree and EPT too, which can be streamed as they are.</summary>
        public bool ConvertOctrees;

        /// <summary>Of the package's shaders, in players.</summary>
        public VariantChoice PlayerVariants = VariantChoice.Automatic;

        /// <summary>Keeps what was changed.</summary>
        public void Save()
        {
            Save(true);
            Apply();
        }

        /// <summary>Has scenes take what they take from the project.</summary>
        public void Apply()
        {
            PointCloudFile.Place = Place;
            PointCloudSystemGroup.DefaultPoolBytes = (long)GpuMiB << 20;
            EditorApplication.QueuePlayerLoopUpdate();
        }

        public ConvertSettings ForConversion(ImportRequest request) => new ConvertSettings
        {
            Sampler = request.Sampler,
            MemoryBytes = (long)MemoryMiB << 20,
            Workers = Workers,
        };
    }
}
