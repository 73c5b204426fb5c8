using System;
using FastPoints.Drawing;
using FastPoints.Entities;
using FastPoints.Rendering;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace FastPoints.Editor
{
    /// <summary>The common start of the package's samples: a scene with Unity's camera and light, settings of point clouds, and
    /// the sample's street.</summary>
    public static class SampleScene
    {
        /// <summary>A position in the street, which runs along X, looking along it.</summary>
        static readonly Vector3 s_eye = new Vector3(-69, 6, -10);
        static readonly Vector3 s_forward = new Vector3(1, -0.06f, 0);

        /// <summary>Makes the scene and closes those that are open, which the user may save first.</summary>
        /// <param name="fill">Adds the content of the sample.</param>
        public static void Create(Action<PointCloudAsset> fill)
        {
            if (EditorApplication.isPlaying)
            {
                // Unity would throw.
                Debug.LogWarning("FastPoints: no scene can be made in play mode: stop it, and choose the sample again");
                return;
            }
            var asset = SampleScan.GetOrImport();
            if (asset != null && EditorSceneManager.SaveCurrentModifiedScenesIfUserWantsTo())
                Create(asset, fill);
        }

        static void Create(PointCloudAsset asset, Action<PointCloudAsset> fill)
        {
            EditorSceneManager.NewScene(NewSceneSetup.DefaultGameObjects, NewSceneMode.Single);
            Camera.main.transform.SetPositionAndRotation(s_eye, Quaternion.LookRotation(s_forward));
            var settings = Add<PointCloudSettings>("Point cloud settings");
            settings.Shape = PointShape.Disc;
            settings.SizeMode = PointSizeMode.Adaptive;
            settings.Size = PointSize.DefaultGaps;
            // Where a scanner saw little, points lie far apart: they must not be drawn that large.
            settings.MaxSizePx = 8;
            settings.EyeDomeLighting = 0.25f;
            fill(asset);
        }

        /// <summary>Makes a GameObject with one component, as the <em>GameObject</em> menu does: Undo removes it.</summary>
        public static T Add<T>(string name)
            where T : Component => ObjectFactory.AddComponent<T>(ObjectFactory.CreateGameObject(name));
    }
}
