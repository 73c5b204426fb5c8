using FastPoints.Gpu;
using FastPoints.Picture;
using Unity.Entities;
using UnityEngine;
using Gradient = FastPoints.Picture.Gradient;

namespace FastPoints.Entities
{
    /// <summary>A converted cloud in a scene of GameObjects: makes the entity that streams it, which stands where the GameObject
    /// does, in edit mode too.</summary>
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [AddComponentMenu("FastPoints/Point Cloud")]
    public sealed class PointCloud : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("The cloud: what the editor makes of a file that is dropped into the project.")]
        PointCloudAsset m_cloud;

        [SerializeField]
        [Tooltip("Without a cloud above, the .fastpoints folder: absolute, or below StreamingAssets.")]
        string m_path;

        [SerializeField]
        [Tooltip("What points are coloured by; another where the cloud has nothing for it.")]
        ColorMode m_color = ColorMode.Auto;

        [SerializeField]
        [Tooltip("Of elevation and intensity.")]
        Gradient m_gradient = Gradient.Auto;

        [SerializeField]
        [Tooltip("Classes, 0 to 255, whose points are not drawn.")]
        int[] m_hiddenClasses = new int[0];

        World m_world;

        /// <summary>Null where <see cref="Path"/> says which.</summary>
        public PointCloudAsset Cloud
        {
            get => m_cloud;
            set
            {
                if (m_cloud == value)
                    return;
                m_cloud = value;
                Reopen();
            }
        }

        /// <summary>Without a <see cref="Cloud"/>, the <c>.fastpoints</c> folder: absolute, or below StreamingAssets.</summary>
        public string Path
        {
            get => m_path;
            set
            {
                if (m_path == value)
                    return;
                m_path = value;
                Reopen();
            }
        }

        /// <summary>What points are coloured by; another where the cloud has nothing for it.</summary>
        public ColorMode Color
        {
            get => m_color;
            set
            {
                if (m_color == value)
                    return;
                m_color = value;
                Reopen();
            }
        }

        /// <summary>Of elevation and intensity.</summary>
        public Gradient Gradient
        {
            get => m_gradient;
            set
            {
                if (m_gradient == value)
                    return;
                m_gradient = value;
                Reopen();
            }
        }

        /// <summary>Classes, 0 to 255, whose points are not drawn. A copy.</summary>
        public int[] HiddenClasses
        {
            get => (int[])m_hiddenClasses.Clone();
            set
            {
                m_hiddenClasses = (int[])value.Clone();
                Reopen();
            }
        }

        /// <summary>Null while the component is disabled.</summary>
        public Entity Entity { get; private set; }

        /// <summary>Opens the folder anew: it was not there, or is another now, or other planes may have to be
        /// streamed.</summary>
        public void Reopen()
        {
            if (!isActiveAndEnabled)
                return;
            Remove();
            Add();
        }

        void OnEnable() => Add();

        void OnDisable() => Remove();

        void Update()
        {
            if (Entity != Entity.Null && m_world.IsCreated)
                m_world.EntityManager.SetComponentData(Entity, TransformMatrix.Of(transform));
        }

        void Add()
        {
            // In edit mode nobody else may have made the world yet.
            DefaultWorldInitialization.DefaultLazyEditModeInitialize();
            m_world = World.DefaultGameObjectInjectionWorld;
            if (m_world == null || (m_cloud == null && string.IsNullOrEmpty(m_path)))
                return;
            var entities = m_world.EntityManager;
            Entity = entities.CreateEntity();
            entities.AddComponentData(Entity, TransformMatrix.Of(transform));
            var file = m_cloud != null ? m_cloud.File() : new PointCloudFile { Path = m_path };
            file.Color = m_color;
            file.Gradient = m_gradient;
            file.HiddenClasses = ClassMask.Of(m_hiddenClasses);
            entities.AddComponentObject(Entity, file);
        }

        void Remove()
        {
            if (m_world != null && m_world.IsCreated && Entity != Entity.Null)
                m_world.EntityManager.DestroyEntity(Entity);
            Entity = Entity.Null;
        }
    }
}
