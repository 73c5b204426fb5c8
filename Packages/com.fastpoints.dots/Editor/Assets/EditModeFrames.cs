using FastPoints.Entities;
using Unity.Entities;
using UnityEditor;

namespace FastPoints.Editor
{
    /// <summary>In edit mode worlds are updated only when something in the scene changes: clouds that come need frames of their
    /// own, and views that are drawn again.</summary>
    [InitializeOnLoad]
    internal static class EditModeFrames
    {
        static World s_world;
        static PointCloudSystemGroup s_group;

        static EditModeFrames()
        {
            if (AssetDatabase.IsAssetImportWorkerProcess())
                return;
            EditorApplication.update += Update;
            // Components see in their updates what has become of their fields.
            Undo.undoRedoPerformed += EditorApplication.QueuePlayerLoopUpdate;
        }

        /// <summary>Once an update of the editor.</summary>
        public static void Update()
        {
            if (EditorApplication.isPlaying || !Wants(World.DefaultGameObjectInjectionWorld))
                return;
            EditorApplication.QueuePlayerLoopUpdate();
            SceneView.RepaintAll();
        }

        static bool Wants(World world)
        {
            if (world == null || !world.IsCreated)
                return false;
            if (world != s_world)
            {
                s_world = world;
                s_group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
            }
            return s_group != null && s_group.WantsFrame;
        }
    }
}
